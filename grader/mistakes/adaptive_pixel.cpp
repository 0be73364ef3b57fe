#include "pt/tasks/adaptive_pixel.h"

#include "grader/mistakes/battery.h"
#include "grader/mistakes/pixels.h"

#include <array>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::AdaptiveSettings;
using pt::Rgb;
using Script = std::function<Rgb(int)>;

pt::PixelEstimate estimate(const Pixel& p, const AdaptiveSettings& settings, std::uint64_t seed,
                           const Script& script) {
  const pt::Scene scene;
  const pt::View view{scene, some_camera(), {}, p.width, p.height};
  pt::Sampler sampler = pt::Sampler::for_pixel(seed, p.x, p.y);
  script_radiance([&](int call, const pt::Ray&) { return script(call); });
  return pt::adaptive_pixel(view, p.x, p.y, settings, sampler);
}

// Returns the number of samples after which the contract stops, if sigma divides by n - `less`.
int right_count(const AdaptiveSettings& s, const Script& script, int less) {
  for (int n = s.batch; n < s.max_samples; n += s.batch) {
    double mean = 0, squares = 0;
    for (int i = 0; i < n; ++i) mean += luminance(script(i)) / n;
    for (int i = 0; i < n; ++i) squares += std::pow(luminance(script(i)) - mean, 2);
    if (1.96 * std::sqrt(squares / (n - less) / n) < s.tolerance * mean * (1 - 1e-9)) return n;
  }
  return s.max_samples;
}

// Sigma may divide by n or by n - 1, so only pixels are used for which both stop at the same count.
void ask(Battery& battery, const AdaptiveSettings& settings, const Script& script,
         const Pixel& p = kPixels[1]) {
  if (right_count(settings, script, 0) != right_count(settings, script, 1)) return;
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
    for (const int batch : {2, 7, 32}) ask(battery, {5 * batch, batch, 0.05}, script);
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
  for (const double value : {1e-9, 1e-4, 1.0}) {
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

// One row per call, because the points of one call need not be independent.
void where(Battery& battery) {
  for (const Pixel& p : kPixels) {
    battery.mean(60, [&](int n, std::uint64_t seed) {
      std::vector<Battery::Numbers> rows;
      for (int i = 0; i < n; ++i) {
        estimate(p, {16, 8, 0.001}, seed + i, [](int k) { return noisy(k, {1, 1, 1}, 1); });
        rows.push_back(mean_place(p));
      }
      return rows;
    });
  }
}

}  // namespace

void run_battery(Battery& battery) {
  constants(battery);
  noises(battery);
  maxima(battery);
  darkness(battery);
  memory(battery);
  where(battery);
}

}  // namespace grader::mistakes
