#include "pt/image/sample_map.h"

#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

namespace pt {
namespace {

// Red and luminance increase from stop to stop.
constexpr std::array<Color8, 3> kSampleStops{{{12, 32, 128}, {150, 52, 152}, {248, 72, 56}}};

constexpr std::size_t kMaxCountsBytes = std::size_t{1} << 29;

}  // namespace

SampleMap sample_map(const Film& film, int max) {
  SampleMap map{film.width, film.height, {}, max};
  map.counts.reserve(film.pixels.size());
  for (const FilmPixel& pixel : film.pixels) map.counts.push_back(pixel.samples);
  return map;
}

Color8 sample_color(int count, int min, int max) {
  const double t = max > min ? (static_cast<double>(count) - min) / (max - min) : 1;
  return ramp(kSampleStops, t);
}

Picture sample_picture(const SampleMap& map) {
  const int min = map.counts.empty() ? 0 : *std::min_element(map.counts.begin(), map.counts.end());
  Picture picture(map.width, map.height);
  for (std::size_t i = 0; i < map.counts.size(); ++i) {
    picture.pixels[i] = sample_color(map.counts[i], min, map.max);
  }
  return with_legend(picture, kSampleStops,
                     {std::to_string(min), std::to_string(min + (map.max - min) / 2),
                      std::to_string(map.max), "samples per pixel"});
}

void write_counts(const std::filesystem::path& path, const SampleMap& map) {
  std::string text;
  for (std::size_t i = 0; i < map.counts.size(); ++i) {
    text += std::to_string(map.counts[i]);
    text += (i + 1) % map.width == 0 ? '\n' : ',';
  }
  write_file(path, text);
}

SampleMap read_counts(const std::filesystem::path& path) {
  const std::string text = read_file(path, kMaxCountsBytes);
  SampleMap map;
  const auto fail = [&](const std::string& why) {
    throw Error(path.string() + ":" + std::to_string(map.height + 1) + ": " + why);
  };
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int columns = 0; at != end;) {
    int count = 0;
    const auto [next, error] = std::from_chars(at, end, count);
    if (error != std::errc{} || count < 0) fail("a count of samples was expected");
    map.counts.push_back(count);
    ++columns;
    if (next == end || (*next != ',' && *next != '\n')) {
      fail("a comma or the end of the line was expected after a count");
    }
    if (*next == '\n') {
      if (map.height > 0 && columns != map.width) {
        fail("the line has " + std::to_string(columns) + " counts, those above have " +
             std::to_string(map.width));
      }
      map.width = columns;
      ++map.height;
      columns = 0;
    }
    at = next + 1;
    if (at == end && columns > 0) fail("the last line breaks off");
  }
  if (!is_image_size(map.width, map.height)) fail("the file has no counts, or too many");
  map.max = *std::max_element(map.counts.begin(), map.counts.end());
  return map;
}

}  // namespace pt
