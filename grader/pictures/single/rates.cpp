#include "grader/pictures/single/rates.h"

#include "grader/pictures/goldens/make_golden.h"
#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::pictures {
namespace {

namespace fs = std::filesystem;

constexpr int kFull = 255;

// The part of the maximum that a colour stands for; nothing if it is none of the map's.
std::optional<double> rate_of(const pt::Color8& color) {
  const auto [r, g, b] = color;
  if (std::min(r, b) != 0 || std::abs(std::max(r, b) + g - kFull) > 2) return std::nullopt;
  return r > 0 ? 1 - 0.5 * g / kFull : 0.5 * g / kFull;
}

int counted(double rate, const pt::AdaptiveSettings& settings) {
  const double count = rate * settings.max_samples;
  const double multiple = std::round(count / settings.batch) * settings.batch;
  const double doubt = 1.5 * settings.max_samples / (2 * kFull) + 0.5;
  if (std::abs(count - multiple) <= doubt && multiple <= settings.max_samples) {
    return static_cast<int>(multiple);
  }
  return static_cast<int>(std::lround(count));
}

// Every number of the verdict lies within five standard deviations of theirs.
bool is_like(const SampleMapVerdict& map, const std::vector<SampleMapVerdict>& each) {
  constexpr double SampleMapVerdict::*kNumbers[] = {
      &SampleMapVerdict::off_batch, &SampleMapVerdict::outside,     &SampleMapVerdict::constant_on,
      &SampleMapVerdict::ratio,     &SampleMapVerdict::correlation, &SampleMapVerdict::a,
      &SampleMapVerdict::b};
  return std::ranges::all_of(kNumbers, [&](double SampleMapVerdict::*number) {
    std::vector<double> values;
    for (const SampleMapVerdict& one : each) values.push_back(one.*number);
    const auto [mean, error] = pt::mean_of(values);
    const double deviation = error * std::sqrt(static_cast<double>(values.size()));
    return std::abs(map.*number - mean) <= 5 * deviation + 1e-3;
  });
}

}  // namespace

pt::Color8 course_color(int count, int max) {
  const double rate = static_cast<double>(count) / max;
  const auto code = [](double part) { return static_cast<std::uint8_t>(kFull * part); };
  const double g = rate <= 0.5 ? 2 * rate : 2 * (1 - rate);
  return rate <= 0.5 ? pt::Color8{0, code(g), code(1 - g)} : pt::Color8{code(1 - g), code(g), 0};
}

pt::SampleMap read_rates(const fs::path& file, const pt::AdaptiveSettings& settings) {
  if (file.extension() == ".csv") {
    pt::SampleMap map = pt::read_counts(file);
    map.max = settings.max_samples;
    return map;
  }
  const pt::Image image = pt::read_image(file);
  pt::SampleMap map{image.width, image.height, {}, settings.max_samples};
  for (const pt::Rgb& pixel : image.pixels) {
    const auto rate = rate_of({pt::encode(pixel.r), pt::encode(pixel.g), pt::encode(pixel.b)});
    if (!rate) {
      throw pt::Error(file.string() +
                      ": its colours are not those of the course's maps of samples, from blue over "
                      "green to red; "
                      "for a map of ./run render -a, name the _rate.csv beside it");
    }
    map.counts.push_back(counted(*rate, settings));
  }
  return map;
}

RatesVerdict judge_rates(const pt::SampleMap& map, const Recipe& recipe, int threads,
                         const std::function<void(double)>& progress) {
  if (map.width != recipe.width || map.height != recipe.height) {
    throw pt::Error(fmt::format("the map has {} x {} pixels, and not {} x {}", map.width,
                                map.height, recipe.width, recipe.height));
  }
  const fs::path kept =
      fs::temp_directory_path() / fmt::format("firstlight_rates_{}.cbor", getpid());
  const GoldenState state = render_golden(recipe, {kRunsOfRates, 1}, threads, kept, progress);
  fs::remove(kept);
  const std::vector<pt::SampleMap> ours = maps_of(recipe, state);
  const pt::Film film = film_of(recipe, state);
  const std::vector<char> dark = dark_starts(recipe, kRunsOfRates, threads);
  const auto judge = [&](const pt::SampleMap& one, const std::vector<pt::SampleMap>& others) {
    SampleMapReference reference = reference_of(others, film, *recipe.adaptive);
    reference.dark_start = dark;
    return judge_sample_map(reference, one);
  };
  const SampleMapVerdict theirs = judge(map, ours);
  if (theirs.pass) return {RatesVerdict::Outcome::agrees, theirs};
  std::vector<SampleMapVerdict> each;
  for (std::size_t one = 0; one < ours.size(); ++one) {
    std::vector<pt::SampleMap> others = ours;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(one));
    each.push_back(judge(ours[one], others));
  }
  return {is_like(theirs, each) ? RatesVerdict::Outcome::cannot_say : RatesVerdict::Outcome::wrong,
          theirs};
}

}  // namespace grader::pictures
