#pragma once

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/generators.h"
#include "grader/check/generators/precision.h"
#include "grader/check/generators/views.h"
#include "grader/check/language/cases.h"
#include "grader/check/language/show.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "pt/tasks/adaptive_pixel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

// Pixels whose radiances a script gives.

namespace grader::check::adaptive_pixel_inputs {

using pt::AdaptiveSettings;
using pt::PixelEstimate;
using pt::Rgb;

// One pixel: the radiance of each sample, and the arguments of adaptive_pixel but for its scene.
// radiance() is a mock version that returns the values of `seen` in order, and the last one again
// if it is called more often.
struct Case {
  std::vector<Rgb> seen;  // one per sample, up to max_samples
  std::string kind{};
  AdaptiveSettings settings;
  pt::Camera camera;
  int x = 0, y = 0, width = 1, height = 1;
  std::uint64_t seed = 0;
};

inline void showValue(const Case& c, std::ostream& out) {
  out << fmt::format(
      "pixel ({}, {}) of {} x {}, batch {}, at most {} samples, tolerance {:.4g}\nsamples: {}", c.x,
      c.y, c.width, c.height, c.settings.batch, c.settings.max_samples, c.settings.tolerance,
      c.kind);
}

inline std::string brief(Rgb c) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", c.r, c.g, c.b); }

struct Answer {
  PixelEstimate estimate;
  std::vector<RadianceCall> calls;
  pt::Sampler sampler;  // its state after the call
};

inline Answer ask(const Case& c, const pt::PathSettings& settings, pt::Sampler sampler,
                  const pt::Scene& scene = {}) {
  script_radiance({.values = c.seen});
  const pt::View view{scene, c.camera, settings, c.width, c.height};
  const PixelEstimate estimate = pt::adaptive_pixel(view, c.x, c.y, c.settings, sampler);
  return {estimate, radiance_calls(), sampler};
}

inline Answer ask(const Case& c, const pt::PathSettings& settings = {}) {
  return ask(c, settings, pt::Sampler(c.seed));
}

// Returns where a ray goes through the pixel: (0, 0) is its lower left corner, (1, 1) its upper
// right one.
inline pt::Vec2 in_pixel(const Case& c, const pt::Ray& ray) {
  const pt::Vec2 at = on_picture(c.camera, ray.direction);
  return {at.x * c.width - c.x, at.y * c.height - c.y};
}

// The radiance of a sample, by its index and a random number in [0, 1).
using Script = std::function<Rgb(int i, double xi)>;

inline std::vector<Rgb> samples(int n, const Script& script, std::uint64_t seed) {
  pt::Sampler chance(seed);
  std::vector<Rgb> samples;
  for (int i = 0; i < n; ++i) samples.push_back(script(i, chance.next_1d()));
  return samples;
}

inline Script always(Rgb value) {
  return [=](int, double) { return value; };
}

// Uniform noise, the same in all three channels.
inline Script noisy(Rgb value, double spread) {
  return [=](int, double xi) { return value * (1 + spread * (2 * xi - 1)); };
}

// Noise in one channel; the other channels are 1.
inline Script noisy_in(int channel) {
  return [=](int, double xi) {
    Rgb color{1, 1, 1};
    color[channel] = 0.02 + 2 * xi;
    return color;
  };
}

// Two values around 1, in turn.
inline Script below_and_above_1(double spread) {
  return [=](int i, double) { return pt::gray(i % 2 == 0 ? 1 - spread : 1 + spread); };
}

inline Script first_then(Rgb first, int how_often, Rgb then) {
  return [=](int i, double) { return i < how_often ? first : then; };
}

// Black, except one sample of `every`.
inline Script lit_once_in(int every, Rgb value, int at = 0) {
  return [=](int i, double) { return i % every == at ? value : Rgb{}; };
}

// In single precision, rounding errors decide below the larger one.
inline double least_tolerance() { return is_single_precision_allowed() ? 2e-3 : 1e-4; }

// Any tolerance, often one of the ends.
inline double any_tolerance() {
  return *rc::gen::oneOf(magnitude(1e-4, 1), magnitude(1e-4, 1), rc::gen::element(1e-4, 1.0));
}

// Settings with any tolerance. The maximum may be a multiple of the batch or not.
inline AdaptiveSettings any_settings() {
  const int batch = *whole(2, 16);
  return {*whole(batch, 10 * batch), batch, any_tolerance()};
}

// Settings with batches of up to thousands of samples.
inline AdaptiveSettings many_samples() {
  const int batch = *rc::gen::element(100, 1000, 3000);
  return {*whole(batch, 3 * batch), batch, *magnitude(1e-4, 0.1)};
}

// Settings with the smallest tolerance. In float, the rounding errors of s2 - s1^2 / n look like
// noise.
inline AdaptiveSettings tight() {
  const int batch = *whole(2, 60);
  return {3 * batch, batch, 1e-4};
}

inline AdaptiveSettings ten_thousand() { return {10000, 10000, 0.01}; }

// A counter of two bytes is too small for the batch or, at least, for all samples.
inline AdaptiveSettings more_than_two_bytes_count() { return {70000, 65537, 0.01}; }

// As many as an int can count.
inline AdaptiveSettings more_than_anybody_takes() {
  return {std::numeric_limits<int>::max(), *whole(2, 100), 0.01};
}

// A pixel of any camera. The last of seventy thousand radiances comes again and again.
inline Case pixel(const std::string& kind, const AdaptiveSettings& settings, const Script& script) {
  Case c;
  c.settings = settings;
  c.kind = kind;
  c.camera = *camera();
  c.width = *whole(1, 40);
  c.height = *whole(1, 30);
  c.x = *whole(0, c.width - 1);
  c.y = *whole(0, c.height - 1);
  c.seed = *sampler_seed();
  c.seen = samples(std::min(settings.max_samples, 70000), script, c.seed + 1);
  return c;
}

inline Rgb any_radiance() { return *magnitude(1e-4, 1e6) * *color(0.1, 1); }

using Settings = AdaptiveSettings (*)();

inline rc::Gen<Case> constant(Settings settings = any_settings) {
  return rc::gen::exec([=] {
    const Rgb value = any_radiance();
    return pixel("always " + brief(value), settings(), always(value));
  });
}

inline rc::Gen<Case> all_black() {
  return rc::gen::exec([] { return pixel("always black", any_settings(), always({})); });
}

// Noise, the same in all three channels. With this tolerance, the interval is narrow enough after a
// few batches, or only beyond the maximum.
inline rc::Gen<Case> noise(Settings some_settings = any_settings) {
  return rc::gen::exec([=] {
    AdaptiveSettings settings = some_settings();
    const Rgb value = any_radiance();
    const double spread = *real(0.1, 1);
    const double most = static_cast<double>(settings.max_samples) / settings.batch;
    const double batches = *real(0.7, 1.1 * most);
    settings.tolerance = 1.96 * spread / std::sqrt(3 * batches * settings.batch);
    return pixel(
        fmt::format("{} (1 + {:.4g} times uniform noise in [-1, 1])", brief(value), spread),
        settings, noisy(value, spread));
  });
}

inline rc::Gen<Case> two_values(Settings settings = any_settings) {
  return rc::gen::exec([=] {
    const Rgb low = any_radiance(), high = *real(1.01, 10) * low;
    const double share = *real(0.2, 0.8);
    return pixel(fmt::format("{} with probability {:.2f}, {} with {:.2f}", brief(low), 1 - share,
                             brief(high), share),
                 settings(), [=](int, double xi) { return xi < share ? high : low; });
  });
}

// A constant value for some batches, then another value.
inline rc::Gen<Case> jump() {
  return rc::gen::exec([] {
    const AdaptiveSettings settings = any_settings();
    const Rgb value = any_radiance();
    const int constant_for = *whole(0, 5) * settings.batch / 2 + 1;
    const double factor = *real(0.1, 10);
    return pixel(fmt::format("{}, from sample {} on {:.4g} times as much", brief(value),
                             constant_for, factor),
                 settings, first_then(value, constant_for, factor * value));
  });
}

// Two values in turn for some batches, then only one of them.
inline rc::Gen<Case> late_jump() {
  return rc::gen::exec([] {
    AdaptiveSettings settings = any_settings();
    settings.max_samples = *whole(6, 12) * settings.batch;
    settings.tolerance = *magnitude(0.02, 0.4);
    const Rgb value = any_radiance();
    const int unsteady_for = *whole(1, 4) * settings.batch - 1;
    const double factor = *real(2, 10);
    return pixel(fmt::format("{} and {:.4g} times as much in turn, from sample {} on the latter",
                             brief(value), factor, unsteady_for),
                 settings, [=](int i, double) {
                   return i < unsteady_for && i % 2 == 0 ? value : factor * value;
                 });
  });
}

// Black, except one sample in every batch or in every second batch. After n samples, ten batches at
// most, sigma / sqrt(n) is a third of the mean or more.
inline rc::Gen<Case> rarely_lit() {
  return rc::gen::exec([] {
    AdaptiveSettings settings = any_settings();
    settings.tolerance = *magnitude(1e-4, 0.05);
    // The square of the least is a number in single precision, where that is allowed.
    const Rgb value = *magnitude(is_single_precision_allowed() ? 1e-15 : 1e-25, 1) * *color(0.1, 1);
    const int every = settings.batch * *whole(1, 2);
    return pixel(fmt::format("{} every {} samples, else black", brief(value), every), settings,
                 lit_once_in(every, value));
  });
}

// Colours whose channels are all different, or of which two are equal.
enum class Channels { all_different, red_is_green, red_is_blue, green_is_blue };

// Samples of one luminance and any hue. The luminance is constant, but the channels and their mean
// are not.
inline rc::Gen<Case> one_brightness(Channels channels) {
  return rc::gen::exec([=] {
    AdaptiveSettings settings = any_settings();
    settings.max_samples = *whole(2, 10) * settings.batch;
    const double brightness = *magnitude(1e-4, 1e6);
    settings.tolerance = *magnitude(1e-4, 0.02);
    return pixel(fmt::format("any hue of the luminance {:.4g}", brightness), settings,
                 [=](int i, double xi) {
                   Rgb hue = i % 2 == 0 ? Rgb{1 + xi, 0.1, 1 - xi} : Rgb{0.1, 1, xi};
                   if (channels == Channels::red_is_green) hue.g = hue.r;
                   if (channels == Channels::red_is_blue) hue.b = hue.r;
                   if (channels == Channels::green_is_blue) hue.b = hue.g;
                   return (brightness / luminance(hue)) * hue;
                 });
  });
}

// Red and green in turn, with the same mean of the channels. The sigma of the luminance is half of
// its mean, so that 160 samples are far too few.
inline rc::Gen<Case> red_and_green() {
  return rc::gen::exec([] {
    AdaptiveSettings settings = any_settings();
    settings.tolerance = *magnitude(1e-4, 0.02);
    const double value = *magnitude(1e-4, 1e6);
    return pixel(fmt::format("red and green in turn, both {:.4g}", value), settings,
                 [=](int i, double) {
                   return i % 2 == 0 ? Rgb{value, 0, 0} : Rgb{0, value, 0};
                 });
  });
}

inline rc::Gen<Case> anything() {
  return rc::gen::oneOf(constant(), all_black(), noise(), noise(), two_values(), jump(),
                        late_jump(), rarely_lit());
}

inline rc::Gen<Case> anything_long() {
  return rc::gen::oneOf(constant(many_samples), noise(many_samples), two_values(many_samples));
}

// All arguments of a call, in a scene with so many lights.
struct Call {
  Case pixel;
  pt::PathSettings settings{};
  int lights = 0;
  std::uint64_t seed = 0;
};

inline void showValue(const Call& c, std::ostream& out) {
  out << show(c.pixel.camera) << '\n';
  showValue(c.pixel, out);
  out << "\nlights: " << c.lights << ", seed: " << c.seed << '\n' << show(c.settings);
}

inline Answer call(const Call& c) {
  return ask(c.pixel, c.settings, pt::Sampler(c.seed), scene_with(c.lights));
}

inline Cases<Call> calls() {
  return {rc::gen::exec([] {
    return Call{*rc::gen::oneOf(noise(), noise(), two_values(), jump(), late_jump()),
                *usual_settings(), *whole(0, 9), *sampler_seed()};
  })};
}

// Of the numbers that decide when a pixel is done.
inline OtherCases<Call> other_ends() {
  return {[](Call& c) { c.pixel.settings.max_samples *= 2; },
          [](Call& c) { c.pixel.settings.max_samples = c.pixel.settings.batch; },
          [](Call& c) { c.pixel.settings.batch = std::max(2, c.pixel.settings.batch / 2); },
          [](Call& c) {
            AdaptiveSettings& s = c.pixel.settings;
            s.max_samples += std::exchange(s.batch, 2) - 2;
          },
          [](Call& c) { c.pixel.settings.tolerance = 1; },
          [](Call& c) { c.pixel.settings.tolerance *= 0.5; }};
}

}  // namespace grader::check::adaptive_pixel_inputs
