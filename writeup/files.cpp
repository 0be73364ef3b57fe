#include "writeup/files.h"

#include "grader/report/embedded.h"
#include "pt/file.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"
#include "pt/image/tone_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr int kStripe = 6;  // pixels, of the hatching
constexpr pt::Color8 kHatch[] = {{86, 90, 96}, {120, 124, 130}};
constexpr int kColors = 1000;

// The nearest number of 11 significant bits.
double rounded(double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return std::bit_cast<float>((bits + 0x1000U) & ~0x1fffU);
}

// Nine bits of each channel and a common exponent in 32 bits (Khronos, EXT_texture_shared_exponent).
std::uint32_t shared_exponent(const pt::Rgb& color) {
  constexpr double kMax = 65408;
  const double r = std::clamp(color.r, 0.0, kMax), g = std::clamp(color.g, 0.0, kMax),
               b = std::clamp(color.b, 0.0, kMax);
  const double largest = std::max({r, g, b});
  if (!(largest > 0)) return 0;
  int exponent = std::max(-16, std::ilogb(largest)) + 16;
  if (std::lround(largest / std::exp2(exponent - 24)) == 512) ++exponent;
  const double scale = std::exp2(exponent - 24);
  const auto part = [&](double value) {
    return static_cast<std::uint32_t>(std::lround(value / scale));
  };
  return part(r) | part(g) << 9 | part(b) << 18 | static_cast<std::uint32_t>(exponent) << 27;
}

template <class Number>
void write_script(const fs::path& name, const char* kind, const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  pt::write_file(fs::path(name) += ".js",
                 fmt::format("firstlight_data(\"{}\",\"{}\",\"{}\")\n", name.filename().string(),
                             kind, grader::report::base64(bytes)));
}

void hatch(const pt::Film& film, pt::Picture& picture) {
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      if (film.at(x, y).samples == 0) picture.at(x, y) = kHatch[(x + y) / kStripe % 2];
    }
  }
}

}  // namespace

void write_film(const fs::path& name, const pt::Film& film, double exposure) {
  pt::Picture picture = pt::tone_map(mean(film), exposure);
  hatch(film, picture);
  pt::write_png(fs::path(name) += ".png", picture);
  pt::Film coarse = film;
  std::vector<std::uint32_t> pixels;
  for (pt::FilmPixel& pixel : coarse.pixels) {
    pixels.push_back(shared_exponent(pixel.mean));
    pixel = {{rounded(pixel.mean.r), rounded(pixel.mean.g), rounded(pixel.mean.b)},
             {},
             0,
             pixel.samples};
  }
  pt::write_exr(fs::path(name) += ".exr", coarse);
  write_script(name, "film", pixels);
}

void write_map(const fs::path& name, const std::vector<float>& values, int width, float low,
               float high) {
  const int height = static_cast<int>(values.size()) / width;
  pt::Picture picture(width, height);
  std::string text;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float value = values[static_cast<std::size_t>(y) * width + x];
      const float t = (value - low) / std::max(high - low, 1e-9F);
      picture.at(x, y) = pt::sample_color(static_cast<int>(std::lround(kColors * t)), 0, kColors);
      text += fmt::format("{:g}{}", value, x + 1 < width ? "," : "\n");
    }
  }
  pt::write_png(fs::path(name) += ".png", picture);
  pt::write_file(fs::path(name) += ".csv", text);
  write_script(name, "map", values);
}

void take_file(const fs::path& from, const fs::path& folder, const std::string& name,
               std::vector<std::string>& list) {
  if (!fs::exists(from)) return;
  if (from.extension() == ".tex") {
    const auto pdf = [](const fs::path& file) { return "{" + file.stem().string() + ".pdf}"; };
    std::string text = pt::read_file(from);
    const std::size_t at = text.find(pdf(from));
    if (at != text.npos) text.replace(at, pdf(from).size(), pdf(name));
    pt::write_file(folder / name, text);
  } else {
    fs::copy_file(from, folder / name, fs::copy_options::overwrite_existing);
  }
  list.push_back(name);
}

}  // namespace writeup
