#include "grader/mistakes/battery.h"

#include "grader/mistakes/pixels.h"
#include "grader/tasks/adaptive_pixel/counts.h"
#include "grader/tasks/adaptive_pixel/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace adaptive_pixel_inputs;

Case pixel(const AdaptiveSettings& settings, const Script& script, const Place& place = kPlaces[1],
           std::uint64_t seed = 1) {
  return {.seen = samples(settings.max_samples, script, 99),
          .settings = settings,
          .camera = fixed_camera(),
          .x = place.x,
          .y = place.y,
          .width = place.width,
          .height = place.height,
          .seed = seed};
}

// Asks for the mean and the number of samples, where all right solutions stop at the same number.
void ask(Battery& battery, const AdaptiveSettings& settings, const Script& script) {
  const Case c = pixel(settings, script);
  if (!has_one_count(c)) return;
  battery.ask([&]() -> Battery::Numbers {
    const auto answer = ask(c);
    const auto [mean, samples] = answer.estimate;
    return {mean.r, mean.g, mean.b, static_cast<double>(samples),
            static_cast<double>(answer.calls.size())};
  });
}

void constants(Battery& battery) {
  for (const double value : {1e-6, 0.1, 1.0, 1000.0 / 3}) {
    const Script script = always({value, value / 3, value / 7});
    for (const int batch : {2, 7, 32, 40}) ask(battery, {5 * batch, batch, 0.05}, script);
    // In float, rounding errors look like noise here.
    for (const int batch : {3, 5}) ask(battery, {3 * batch, batch, 1e-4}, script);
  }
}

// This many samples show a sum in float: its error is four times the allowed one.
void many_samples(Battery& battery) {
  constexpr double kValue = 0.7;
  battery.ask([&]() -> Battery::Numbers {
    const auto [mean, samples] = ask(pixel({4200, 4200, 0.05}, always(pt::gray(kValue)))).estimate;
    return {static_cast<double>(samples), flag(std::abs(mean.g / kValue - 1) < 2e-5)};
  });
}

// Two values in turn. After the first batch, the interval is a little wider or narrower than the
// tolerance; it becomes narrower with each batch.
void limits(Battery& battery) {
  struct {
    AdaptiveSettings settings;
    double interval;  // after the first batch, if sigma divides by n
  } constexpr kLimits[] = {{{24, 8, 2e-4}, 2.5e-4},
                           {{24, 8, 1.2e-4}, 1.4e-4},
                           {{40, 8, 3e-3}, 5e-3},
                           {{12, 4, 0.8}, 0.6},
                           {{120, 4, 0.05}, 0.2214},  // narrow after 20 batches
                           {{1600, 800, 0.02}, 0.02 * (1 + 1.5e-4)},
                           {{1600, 800, 0.02}, 0.02 * (1 - 7.75e-4)}};
  for (const auto& [settings, interval] : kLimits) {
    const double spread = interval * std::sqrt(settings.batch) / 1.96;
    ask(battery, settings, below_and_above_1(spread));
  }
}

void noises(Battery& battery) {
  const Rgb color{0.9, 0.5, 0.2};
  for (const double value : {1e-3, 0.02, 1.0, 20.0}) {
    for (const double spread : {0.3, 1.0}) {
      for (const double tolerance : {0.02, 0.05, 0.1, 0.2, 0.5}) {
        const Script script = noisy(value * color, spread);
        ask(battery, {200, 8, tolerance}, script);
        ask(battery, {150, 20, tolerance}, script);
      }
    }
  }
  // The channels have different noise.
  for (int channel = 0; channel < 3; ++channel) {
    for (const double tolerance : {0.03, 0.06, 0.1}) {
      ask(battery, {160, 8, tolerance}, noisy_in(channel));
    }
  }
}

// Pixels that reach the maximum, which is a multiple of the batch or not.
void maxima(Battery& battery) {
  constexpr std::array<int, 2> kLimits[] = {{8, 8}, {20, 8}, {21, 7}, {33, 32}, {64, 16}, {5, 2}};
  for (const auto& [max_samples, batch] : kLimits) {
    ask(battery, {max_samples, batch, 0.001}, noisy({1, 2, 3}, 1));
  }
}

void darkness(Battery& battery) {
  for (const double brightness : {1e-20, 1e-9, 1e-4, 1.0}) {
    const Rgb value = pt::gray(brightness);
    for (const int every : {5, 16, 24}) {
      for (const int at : {0, every - 1}) {
        ask(battery, {80, 8, 0.05}, lit_once_in(every, value, at));
      }
    }
    ask(battery, {200, 8, 0.1}, noisy(value, 1));
  }
  // One constant for some batches, then another constant.
  for (const int steady : {7, 9, 20}) {
    ask(battery, {96, 8, 0.05}, first_then({1, 1, 1}, steady, {5, 3, 2}));
  }
}

// The same pixel after other pixels.
void memory(Battery& battery) {
  const Place place = kPlaces[1], left{place.x - 1, place.y, place.width, place.height};
  const Case c = pixel({120, 8, 0.1}, noisy({1, 2, 3}, 0.5), place);
  battery.ask([&]() -> Battery::Numbers {
    Battery::Numbers all;
    for (const double before : {0.0, 1.0, 50.0}) {
      ask(pixel({16, 8, 0.5}, always(pt::gray(before)), left, 3));
      const auto [mean, samples] = ask(c).estimate;
      all.insert(all.end(), {mean.g, static_cast<double>(samples)});
    }
    return all;
  });
}

std::vector<pt::Vec2> points_of(const Case& c) {
  std::vector<pt::Vec2> points;
  for (const RadianceCall& call : ask(c).calls) points.push_back(in_pixel(c, call.ray));
  return points;
}

// One row per call, because the points of one call need not be independent. The last batch of some
// calls is cut short.
void where(Battery& battery) {
  struct {
    Place place;
    int max_samples, batch, calls;
  } constexpr kCalls[] = {{kPlaces[0], 16, 8, 60},
                          {kPlaces[1], 16, 8, 60},
                          {kPlaces[2], 16, 8, 60},
                          {kPlaces[1], 48, 32, 20}};
  for (const auto& each : kCalls) {
    battery.mean(each.calls, [&](int n, std::uint64_t seed) {
      std::vector<Battery::Numbers> rows;
      for (int i = 0; i < n; ++i) {
        const AdaptiveSettings settings{each.max_samples, each.batch, 0.001};
        rows.push_back(
            mean_place(points_of(pixel(settings, noisy({1, 1, 1}, 1), each.place, seed + i))));
      }
      return rows;
    });
  }
}

// Returns the share of points in the centre of the pixel, and the share of those on a grid of 64 x
// 64 places.
Battery::Numbers special_points(const std::vector<pt::Vec2>& points) {
  Battery::Numbers shares(2);
  const double n = static_cast<double>(points.size());
  const auto is_whole = [](double x) { return std::abs(x - std::round(x)) < 5e-3; };
  for (const auto [x, y] : points) {
    shares[0] += flag(std::abs(x - 0.5) < 1e-4 && std::abs(y - 0.5) < 1e-4) / n;
    shares[1] += flag(is_whole(64 * x) && is_whole(64 * y)) / n;
  }
  return shares;
}

// Asks how many points are in such places, in the only pixel of a picture, where points are
// precise; and whether they are in their pixel, in a picture of many rows.
void special_places(Battery& battery) {
  const Script gray_noise = noisy({1, 1, 1}, 1);
  battery.mean(20, [&](int n, std::uint64_t seed) {
    std::vector<Battery::Numbers> rows;
    for (int i = 0; i < n; ++i) {
      const Case c = pixel({12, 4, 0.001}, gray_noise, kPlaces[0], seed + i);
      rows.push_back(special_points(points_of(c)));
    }
    return rows;
  });
  battery.ask([&]() -> Battery::Numbers {
    const std::vector<pt::Vec2> points =
        points_of(pixel({4, 4, 0.05}, gray_noise, {3, 90, 8, 100}));
    return {flag(std::ranges::all_of(points, [](pt::Vec2 at) {
      return std::min(at.x, at.y) > -0.01 && std::max(at.x, at.y) < 1.01;
    }))};
  });
}

// The settings that radiance() gets, and whether the sampler moves on.
void passed_on(Battery& battery) {
  battery.ask([]() -> Battery::Numbers {
    const pt::PathSettings settings = fixed_settings();
    const Case c = pixel({4, 4, 0.05}, always(pt::gray(1)), kPlaces[1], 7);
    const auto answer = ask(c, settings);
    if (answer.calls.empty()) return {};
    const pt::PathSettings& seen = answer.calls.back().settings;
    return {static_cast<double>(seen.light_samples),
            flag(seen.direct == settings.direct),
            seen.survival,
            static_cast<double>(seen.from),
            static_cast<double>(seen.to),
            flag(answer.sampler.state() != pt::Sampler(c.seed).state())};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  constants(battery);
  many_samples(battery);
  limits(battery);
  noises(battery);
  maxima(battery);
  darkness(battery);
  memory(battery);
  where(battery);
  special_places(battery);
  passed_on(battery);
}

}  // namespace grader::mistakes
