#include "pt/tasks/adaptive_pixel.h"

#include "grader/mistakes/battery.h"
#include "grader/mistakes/pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::AdaptiveSettings;
using pt::Rgb;
using Script = std::function<Rgb(int)>;

pt::PixelEstimate estimate(const Pixel& p, const AdaptiveSettings& settings, pt::Sampler& sampler,
                           const Script& script, const pt::PathSettings& of_paths = {}) {
  const pt::Scene scene;
  const pt::View view{scene, some_camera(), of_paths, p.width, p.height};
  script_radiance([&](int call, const pt::Ray&) { return script(call); });
  return pt::adaptive_pixel(view, p.x, p.y, settings, sampler);
}

pt::PixelEstimate estimate(const Pixel& p, const AdaptiveSettings& settings, std::uint64_t seed,
                           const Script& script) {
  pt::Sampler sampler = pt::Sampler::for_pixel(seed, p.x, p.y);
  return estimate(p, settings, sampler, script);
}

// Returns the number of samples after which the contract stops, if sigma divides by n - `less`.
int right_count(const AdaptiveSettings& s, const Script& script, int less) {
  for (int n = s.batch; n < s.max_samples; n += s.batch) {
    double mean = 0, squares = 0;
    for (int i = 0; i < n; ++i) mean += luminance(script(i)) / n;
    for (int i = 0; i < n; ++i) squares += std::pow(luminance(script(i)) - mean, 2);
    if (1.96 * std::sqrt(squares / (n - less) / n) < s.tolerance * mean) return n;
  }
  return s.max_samples;
}

// Returns whether all right solutions stop at the same count. Sigma may divide by n or by n - 1, the
// sides of the condition may be off by 2e-5, and where all samples are black, < and <= are right.
bool has_one_count(const AdaptiveSettings& settings, const Script& script) {
  bool black = true;
  for (int i = 0; i < settings.batch; ++i) black = black && is_black(script(i));
  const int count = right_count(settings, script, 0);
  bool same = !black;
  for (const double off : {1 - 5e-5, 1 + 5e-5}) {
    AdaptiveSettings other = settings;
    other.tolerance *= off;
    for (const int less : {0, 1}) same = same && right_count(other, script, less) == count;
  }
  return same;
}

void ask(Battery& battery, const AdaptiveSettings& settings, const Script& script,
         const Pixel& p = kPixels[1]) {
  if (!has_one_count(settings, script)) return;
  battery.ask([&]() -> Battery::Numbers {
    const auto [mean, samples] = estimate(p, settings, 1, script);
    return {mean.r, mean.g, mean.b, static_cast<double>(samples),
            static_cast<double>(radiance_calls().size())};
  });
}

Rgb noisy(int i, Rgb color, double spread) { return color * (1 + spread * (2 * noise(i) - 1)); }

void constants(Battery& battery) {
  for (const double value : {1e-6, 0.1, 1.0, 1000.0 / 3}) {
    const Script script = [=](int) { return Rgb{value, value / 3, value / 7}; };
    for (const int batch : {2, 7, 32, 40}) ask(battery, {5 * batch, batch, 0.05}, script);
    // In float, rounding errors look like noise here.
    for (const int batch : {3, 5}) ask(battery, {3 * batch, batch, 1e-4}, script);
  }
}

// So many samples show a sum in float, which is four times as far off as the mean may be.
void many_samples(Battery& battery) {
  constexpr double kValue = 0.7;
  battery.ask([&]() -> Battery::Numbers {
    const auto [mean, samples] =
        estimate(kPixels[1], {4200, 4200, 0.05}, 1, [](int) { return pt::gray(kValue); });
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
    ask(battery, settings, [=](int i) { return pt::gray(1 + (i % 2 == 0 ? -spread : spread)); });
  }
}

void noises(Battery& battery) {
  const Rgb color{0.9, 0.5, 0.2};
  for (const double value : {1e-3, 0.02, 1.0, 20.0}) {
    for (const double spread : {0.3, 1.0}) {
      for (const double tolerance : {0.02, 0.05, 0.1, 0.2, 0.5}) {
        const Script script = [=](int i) { return noisy(i, value * color, spread); };
        ask(battery, {200, 8, tolerance}, script);
        ask(battery, {150, 20, tolerance}, script);
      }
    }
  }
  // The channels have different noise.
  for (int channel = 0; channel < 3; ++channel) {
    const Script script = [=](int i) {
      Rgb c{1, 1, 1};
      c[channel] *= 0.02 + 2 * noise(i);
      return c;
    };
    for (const double tolerance : {0.03, 0.06, 0.1}) ask(battery, {160, 8, tolerance}, script);
  }
}

// Pixels that reach the maximum, which is a multiple of the batch or not.
void maxima(Battery& battery) {
  const Script script = [](int i) { return noisy(i, {1, 2, 3}, 1); };
  constexpr std::array<int, 2> kLimits[] = {{8, 8}, {20, 8}, {21, 7}, {33, 32}, {64, 16}, {5, 2}};
  for (const auto& [max_samples, batch] : kLimits) {
    ask(battery, {max_samples, batch, 0.001}, script);
  }
}

void darkness(Battery& battery) {
  for (const double value : {1e-20, 1e-9, 1e-4, 1.0}) {
    for (const int every : {5, 16, 24}) {
      ask(battery, {80, 8, 0.05}, [=](int i) {
        return i % every == 0 ? Rgb{value, value, value} : Rgb{};
      });
      ask(battery, {80, 8, 0.05}, [=](int i) {
        return i % every == every - 1 ? Rgb{value, value, value} : Rgb{};
      });
    }
    ask(battery, {200, 8, 0.1}, [=](int i) { return noisy(i, {value, value, value}, 1); });
  }
  // One constant for some batches, then another one.
  for (const int steady : {7, 9, 20}) {
    ask(battery, {96, 8, 0.05}, [=](int i) { return i < steady ? Rgb{1, 1, 1} : Rgb{5, 3, 2}; });
  }
}

// The same pixel after other pixels.
void memory(Battery& battery) {
  const Pixel p = kPixels[1];
  const AdaptiveSettings settings{120, 8, 0.1};
  const Script script = [](int i) { return noisy(i, {1, 2, 3}, 0.5); };
  battery.ask([&]() -> Battery::Numbers {
    Battery::Numbers all;
    for (const double before : {0.0, 1.0, 50.0}) {
      const Pixel left{p.x - 1, p.y, p.width, p.height};
      estimate(left, {16, 8, 0.5}, 3, [=](int) { return Rgb{before, before, before}; });
      const auto [mean, samples] = estimate(p, settings, 1, script);
      all.insert(all.end(), {mean.g, static_cast<double>(samples)});
    }
    return all;
  });
}

// One row per call, because the points of one call need not be independent. The last batch of some
// calls is cut short.
void where(Battery& battery) {
  struct {
    Pixel pixel;
    int max_samples, batch, calls;
  } constexpr kCalls[] = {{kPixels[0], 16, 8, 60},
                          {kPixels[1], 16, 8, 60},
                          {kPixels[2], 16, 8, 60},
                          {kPixels[1], 48, 32, 20}};
  for (const auto& each : kCalls) {
    battery.mean(each.calls, [&](int n, std::uint64_t seed) {
      std::vector<Battery::Numbers> rows;
      for (int i = 0; i < n; ++i) {
        estimate(each.pixel, {each.max_samples, each.batch, 0.001}, seed + i, [](int k) {
          return noisy(k, {1, 1, 1}, 1);
        });
        rows.push_back(mean_place(each.pixel));
      }
      return rows;
    });
  }
}

// Returns the share of points in the centre of the pixel, and the share of those on a grid of 64 x 64
// places. `p` is the only pixel of its picture, where points are precise.
Battery::Numbers special_points(const Pixel& p) {
  Battery::Numbers shares(2);
  const double calls = static_cast<double>(radiance_calls().size());
  const auto is_whole = [](double x) { return std::abs(x - std::round(x)) < 5e-3; };
  for (const RadianceCall& call : radiance_calls()) {
    const auto [x, y] = in_pixel(p, call.ray);
    shares[0] += flag(std::abs(x - 0.5) < 1e-4 && std::abs(y - 0.5) < 1e-4) / calls;
    shares[1] += flag(is_whole(64 * x) && is_whole(64 * y)) / calls;
  }
  return shares;
}

// Asks how many points are in such places, and whether they are in their pixel, in a picture of many
// rows.
void special_places(Battery& battery) {
  const Script noise_of_gray = [](int i) { return noisy(i, {1, 1, 1}, 1); };
  battery.mean(20, [&](int n, std::uint64_t seed) {
    std::vector<Battery::Numbers> rows;
    for (int i = 0; i < n; ++i) {
      estimate(kPixels[0], {12, 4, 0.001}, seed + i, noise_of_gray);
      rows.push_back(special_points(kPixels[0]));
    }
    return rows;
  });
  battery.ask([&]() -> Battery::Numbers {
    const Pixel p{3, 90, 8, 100};
    estimate(p, {4, 4, 0.05}, 1, noise_of_gray);
    bool inside = true;
    for (const RadianceCall& call : radiance_calls()) {
      const auto [x, y] = in_pixel(p, call.ray);
      inside = inside && std::min(x, y) > -0.01 && std::max(x, y) < 1.01;
    }
    return {flag(inside)};
  });
}

// The settings that radiance() gets, and whether the sampler moves on.
void passed_on(Battery& battery) {
  const pt::PathSettings settings = some_settings();
  battery.ask([&]() -> Battery::Numbers {
    const pt::Sampler start(7);
    pt::Sampler sampler = start;
    estimate(
        kPixels[1], {4, 4, 0.05}, sampler, [](int) { return pt::gray(1); }, settings);
    if (radiance_calls().empty()) return {};
    const pt::PathSettings& seen = radiance_calls().back().settings;
    return {static_cast<double>(seen.light_samples),
            flag(seen.direct == settings.direct),
            seen.survival,
            static_cast<double>(seen.from),
            static_cast<double>(seen.to),
            flag(sampler.state() != start.state())};
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
