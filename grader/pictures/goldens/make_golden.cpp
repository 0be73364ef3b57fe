#include "grader/pictures/goldens/make_golden.h"

#include "grader/base/sha256.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/pictures/recipes/seeds.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/render_film.h"

#include <cassert>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

// Another build of the reference may have begun another picture.
std::string program_hash() { return base::sha256(pt::read_file("/proc/self/exe", kMaxBytes)); }

// CBOR keeps every bit of a number: a golden that was interrupted is the same golden.
void save(const std::filesystem::path& file, const GoldenState& state) {
  std::vector<double> numbers;
  for (const PixelMoments& pixel : state.pixels) {
    numbers.push_back(pixel.samples);
    numbers.insert(numbers.end(), pixel.mean.begin(), pixel.mean.end());
    numbers.insert(numbers.end(), pixel.squares.begin(), pixel.squares.end());
  }
  const std::vector<std::uint8_t> bytes = json::to_cbor({{"hash", state.hash},
                                                         {"samples", state.samples},
                                                         {"parts", state.parts},
                                                         {"cpu_seconds", state.cpu_seconds},
                                                         {"pixels", numbers},
                                                         {"counts", state.counts}});
  pt::write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

GoldenState read(const std::string& bytes) {
  const json from = json::from_cbor(bytes);
  GoldenState state;
  from.at("hash").get_to(state.hash);
  from.at("samples").get_to(state.samples);
  from.at("parts").get_to(state.parts);
  from.at("cpu_seconds").get_to(state.cpu_seconds);
  from.at("counts").get_to(state.counts);
  const std::vector<double> numbers = from.at("pixels");
  for (std::size_t i = 0; i + 9 <= numbers.size(); i += 9) {
    const double* of = &numbers[i];
    state.pixels.push_back({of[0], {of[1], of[2], of[3], of[4]}, {of[5], of[6], of[7], of[8]}});
  }
  return state;
}

// The kept state of this picture. Nothing if its file is missing, cannot be read, or has the state of
// another picture.
std::optional<GoldenState> load(const std::filesystem::path& file, const GoldenState& fresh,
                                int most_parts) {
  if (!std::filesystem::exists(file)) return {};
  try {
    GoldenState state = read(pt::read_file(file, kMaxBytes));
    if (state.hash == fresh.hash && state.samples == fresh.samples && state.parts <= most_parts &&
        state.pixels.size() == fresh.pixels.size()) {
      return state;
    }
  } catch (const json::exception&) {
  }
  return {};
}

void add(GoldenState& state, const pt::RenderResult& part, bool adaptive) {
  std::vector<int> counts;
  for (std::size_t i = 0; i < state.pixels.size(); ++i) {
    const pt::FilmPixel& pixel = part.film.pixels[i];
    state.pixels[i] = merge(state.pixels[i], adaptive ? one_sample(pixel) : moments_of(pixel));
    counts.push_back(pixel.samples);
  }
  if (adaptive) state.counts.push_back(std::move(counts));
  state.cpu_seconds += part.cpu_seconds;
  ++state.parts;
}

}  // namespace

Effort usual_effort(const Recipe& recipe) {
  if (recipe.adaptive) return {256, 1};
  return recipe.noisy ? Effort{32, 512} : Effort{16, 256};
}

GoldenState render_golden(const Recipe& recipe, const Effort& effort, int threads,
                          const std::filesystem::path& partial,
                          const std::function<void(double)>& progress) {
  GoldenState fresh{picture_hash(recipe) + program_hash(), effort.samples, 0, 0, {}, {}};
  fresh.pixels.resize(static_cast<std::size_t>(recipe.width) * recipe.height);
  GoldenState state = load(partial, fresh, effort.parts).value_or(fresh);
  const RecipeScene scene = load_scene(recipe, pt::Engine::wide);
  const pt::View picture = view(recipe, scene);
  while (state.parts < effort.parts) {
    const std::uint64_t seed = golden_seed(recipe, static_cast<std::uint32_t>(state.parts));
    const pt::RenderResult part =
        render_film(picture, {effort.samples, recipe.adaptive, seed, threads});
    if (part.not_finite > 0) {
      throw pt::Error(fmt::format(
          "recipe '{}': {} samples are not finite, the first at pixel x {} y {} (from the bottom "
          "left) with seed {}; correct the reference first",
          recipe.name, part.not_finite, part.first_bad->x, part.first_bad->y, seed));
    }
    add(state, part, recipe.adaptive.has_value());
    save(partial, state);
    progress(static_cast<double>(state.parts) / effort.parts);
  }
  return state;
}

std::vector<char> dark_starts(const Recipe& recipe, int runs, int threads) {
  const RecipeScene scene = load_scene(recipe, pt::Engine::wide);
  const pt::View picture = view(recipe, scene);
  // A run of only one batch takes the same samples as the first batch of the whole run.
  pt::AdaptiveSettings first = *recipe.adaptive;
  first.max_samples = first.batch;
  std::vector<char> dark(static_cast<std::size_t>(recipe.width) * recipe.height);
  for (int run = 0; run < runs; ++run) {
    const std::uint64_t seed = golden_seed(recipe, static_cast<std::uint32_t>(run));
    const pt::RenderResult batch = render_film(picture, {1, first, seed, threads});
    for (std::size_t i = 0; i < dark.size(); ++i) {
      if (is_black(batch.film.pixels[i].mean)) dark[i] = 1;
    }
  }
  return dark;
}

pt::Film film_of(const Recipe& recipe, const GoldenState& state) {
  pt::Film film(recipe.width, recipe.height);
  assert(film.pixels.size() == state.pixels.size());
  for (std::size_t i = 0; i < film.pixels.size(); ++i) film.pixels[i] = film_pixel(state.pixels[i]);
  return film;
}

std::vector<pt::SampleMap> maps_of(const Recipe& recipe, const GoldenState& state) {
  std::vector<pt::SampleMap> maps;
  for (const std::vector<int>& counts : state.counts) {
    maps.push_back({recipe.width, recipe.height, counts, recipe.adaptive->max_samples});
  }
  return maps;
}

PixelMoments one_sample(const pt::FilmPixel& pixel) {
  return {1, {pixel.mean.r, pixel.mean.g, pixel.mean.b, luminance(pixel.mean)}, {}};
}

PixelMoments moments_of(const pt::FilmPixel& pixel) {
  PixelMoments moments = one_sample(pixel);
  moments.samples = pixel.samples;
  const double degrees = pixel.samples - 1;
  moments.squares = {degrees * pixel.variance.r, degrees * pixel.variance.g,
                     degrees * pixel.variance.b, degrees * pixel.variance_y};
  return moments;
}

PixelMoments merge(const PixelMoments& a, const PixelMoments& b) {
  PixelMoments sum;
  sum.samples = a.samples + b.samples;
  if (sum.samples == 0) return sum;
  const double part = b.samples / sum.samples;
  for (int i = 0; i < 4; ++i) {
    const double step = b.mean[i] - a.mean[i];
    sum.mean[i] = a.mean[i] + part * step;
    sum.squares[i] = a.squares[i] + b.squares[i] + a.samples * part * step * step;
  }
  return sum;
}

pt::FilmPixel film_pixel(const PixelMoments& moments) {
  const auto variance = [&](int i) {
    return moments.samples < 2 ? 0 : moments.squares[i] / (moments.samples - 1);
  };
  return {{moments.mean[0], moments.mean[1], moments.mean[2]},
          {variance(0), variance(1), variance(2)},
          variance(3),
          static_cast<int>(std::lround(moments.samples))};
}

}  // namespace grader::pictures
