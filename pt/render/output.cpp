#include "pt/render/output.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/exr.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"
#include "pt/memory.h"
#include "pt/printable.h"
#include "pt/render/rounds.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace pt {

namespace {

std::filesystem::path beside(const std::filesystem::path& picture, const char* ending) {
  std::filesystem::path path = picture;
  return path.replace_filename(picture.stem().string() + ending);
}

template <class Value>
std::string word_of(const std::map<std::string, Value>& words, Value value) {
  return std::ranges::find(words, value, &std::pair<const std::string, Value>::second)->first;
}

// All that decides the numbers of a picture, except the number of its samples.
std::string settings_line(const RenderOptions& options) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a (Fowler, Noll and Vo 1991)
  for (const char byte : read_file(options.scene)) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  const PathSettings path = path_settings(options);
  const bool hemisphere = path.direct == PathSettings::Direct::hemisphere;
  std::string text = fmt::format(
      "seed {} scene {:016x} size {} {} camera {} light {} bounces {} {} {} {} survival {}{}{}{}",
      options.seed, hash, options.width, options.height, word_of(kFramingWords, options.framing),
      word_of(kLightWords, options.load.light), path.from, path.to,
      hemisphere ? "hemisphere" : "lights", path.light_samples, path.survival,
      path.show_normals ? " normals" : "", options.load.lambertian ? " lambertian" : "",
      options.load.common_emission ? " common-emission" : "");
  if (const auto& a = options.adaptive) {
    text += fmt::format(" adaptive {} {} {}", a->max_samples, a->batch, a->tolerance);
  }
  return text;
}

}  // namespace

void check_targets(const RenderOptions& options) {
  check_image_target(options.output);
  if (options.adaptive) {
    for (const char* ending : {"_rate.png", "_rate.csv"}) {
      check_target(beside(options.output, ending));
    }
  }
  if (!options.notes.empty()) check_target(options.notes);
  const auto pixels = static_cast<std::uint64_t>(options.width) * options.height;
  const std::uint64_t needed =
      pixels * (sizeof(FilmPixel) + (is_exr_name(options.output) ? 100 : 40));
  if (const std::uint64_t left = memory_left(); needed > left) {
    throw Error(fmt::format("a picture of {} x {} needs {}, and {} are left; give a smaller -r",
                            options.width, options.height, shown_bytes(needed), shown_bytes(left)));
  }
}

Film picture_to_go_on_with(const RenderOptions& options) {
  if (options.resume.empty()) return {};
  const std::string name = options.resume.string();
  const std::string bytes = read_file(options.resume, kMaxPictureBytes);
  if (!starts_as_exr(bytes) || exr_settings(bytes, name).empty()) {
    throw Error("cannot go on with '" + name +
                "': it is not an .exr that ./run render has written");
  }
  const std::string made = exr_settings(bytes, name), wanted = settings_line(options);
  if (made != wanted) {
    throw Error(fmt::format(
        "cannot go on with '{}': it was made with [{}], and the options here are [{}]; give "
        "the same options and scene",
        name, made, wanted));
  }
  Film film = decode_exr(bytes, name);
  if (film.width != options.width || film.height != options.height) {
    throw Error("cannot go on with '" + name + "': its size is not that of its own settings");
  }
  return film;
}

void write_pictures(const RenderOptions& options, const Film& film) {
  write_image(options.output, film, options.exposure,
              is_exr_name(options.output) ? settings_line(options) : "");
  fmt::print("wrote {}\n", printable(options.output.string()));
  if (!options.adaptive) return;
  const SampleMap map = sample_map(film, options.adaptive->max_samples);
  const auto picture = beside(options.output, "_rate.png");
  const auto counts = beside(options.output, "_rate.csv");
  write_png(picture, sample_picture(map));
  write_counts(counts, map);
  fmt::print("wrote {} and {}\n", printable(picture.string()), printable(counts.string()));
}

std::string note_on_missing_samples(const RenderOptions& options, const Film& film,
                                    bool is_interrupted) {
  const SampleRange samples = samples_of(film);
  std::string text = is_interrupted ? "interrupted" : "the time is over";
  text += fmt::format(": the picture has {}", samples.least);
  if (samples.most > samples.least) text += fmt::format(" to {}", samples.most);
  if (options.seconds == std::nullopt) text += fmt::format(" of {}", options.samples);
  text += " samples per pixel; ";
  if (!is_exr_name(options.output)) return text + "to go on with one later, write an .exr";
  return text + "the same command with --resume " + options.output.string() + " goes on";
}

}  // namespace pt
