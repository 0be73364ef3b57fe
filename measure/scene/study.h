#pragma once

#include "measure/scene/model.h"
#include "measure/scene/pixels.h"
#include "pt/image/accuracy.h"
#include "pt/image/compare.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

// Measures what a way to follow light needs for an error. pt/image/accuracy.h defines the error.

namespace measure::scene {

using pt::kSignificant;
// The root of a squared bias, if it is not only noise.
std::optional<double> seen_bias(const Uncertain& bias2);
// If the variance's own error is a larger part of it, a few samples make it.
inline constexpr double kHeavy = 0.1;

// The way to follow light: all settings but the numbers of samples.
struct Way {
  pt::PathSettings::Direct direct = pt::PathSettings::Direct::lights;
  int bounces = 5;
  double survival = pt::PathSettings{}.survival;

  bool operator==(const Way&) const = default;
};

pt::PathSettings path_of(const Way& way, int light_samples);

// Some pixels of a picture, made with the chosen numbers.
struct Checked {
  Uncertain error;     // root of relMSE: noise and bias
  double seconds = 0;  // of processor time, per pixel
  double samples = 0;  // per pixel
  double rays = 0;     // per pixel
  std::size_t pixels = 0;
  Uncertain bias2;               // the square of the relative bias, which is a part of error^2
  pt::PixelErrors pixel_errors;  // without the bias
  // The pixels that see no light at all, and the samples that they took: parts of all.
  double black_pixels = 0, black_samples = 0;
};

// The number of bounces that are measured separately. All later bounces are one rest.
inline constexpr int kToldApart = 16;
inline constexpr int kMaxWithoutTree = 30000;  // surfaces: the limit for testing all, one by one
inline constexpr int kAllBounces = 100;        // as in trace_path

// The limits of a study.
struct StudyLimits {
  double seconds = 45;  // for everything, approximate, by the wall clock
  int samples = 0;      // per pixel of each render, even; 0: as many as there is time for
  int pixels = 10000;   // the approximate number of pixels to measure
};

// A right picture of all pixels of a study, in luminance, with these settings.
using Reference = std::function<std::vector<double>(const pt::PathSettings& path, int samples,
                                                    std::uint64_t seed)>;

// A view to find settings for. All renders have the same pixels, each with its own random numbers.
class Study {
 public:
  // `progress` is called with the part of the time that has been used, and `announce`, soon after the
  // beginning, with the seconds that all will take by what the first samples took. `bounces` is for
  // the picture that errors are measured against: at most kToldApart, or kAllBounces. Without a
  // `reference` it is made by the measured code, whose mistakes are in it: then errors are noise, and what
  // few bounces leave out.
  Study(const pt::View& view, int threads, std::uint64_t seed, const StudyLimits& limits,
        std::function<void(double)> progress, int bounces = kAllBounces,
        const std::function<void(double)>& announce = {}, const Reference& reference = {});

  // The time of all renders so far.
  double cpu_seconds() const { return cpu_seconds_; }

  // Returns whether errors are measured against the pictures of other code.
  bool has_reference() const { return has_reference_; }

  // Returns whether no light at all reaches the camera.
  bool is_black() const;

  // The square of the relative bias that is left with 0, 1, ... kToldApart bounces at most.
  const std::vector<Uncertain>& bias2() const { return bias2_; }
  // The same for any number of bounces: nothing is left with more.
  double bias2_at(int bounces) const { return bounces <= kToldApart ? bias2_[bounces].value : 0; }

  // Short renders with these numbers of light samples, taken in turns.
  std::vector<Tried> try_out(const Way& way, const std::vector<int>& light_samples);

  // The noise of each pixel: the variance of a camera sample.
  struct PixelNoise {
    double relative = 0;     // v / (g + d)^2, as in relMSE
    double over_square = 0;  // v / g^2, as in adaptive sampling
  };
  std::vector<PixelNoise> pixel_noise(const Way& way, int light_samples);

  // The picture with these settings, rendered twice, with as many pixels as there is time for; one
  // takes about `seconds`. The square of its error is half the squared difference of the two, which is
  // noise, and the square of the bias. That is `bias2` for a picture of independent samples, which
  // has the bias of its way. Without it, the two pictures and the long renders show the bias: a pixel
  // of adaptive sampling may stop too early. It may take the given part of the time.
  Checked check(const pt::PathSettings& path, const pt::RenderSettings& settings, double seconds,
                const std::optional<Uncertain>& bias2, double part = 0.08);

  // The time of the same picture with the tracer of `other`, over the usual time. Both take turns.
  Uncertain times_as_long(const pt::Scene& other, const Way& way, int light_samples);

  // The long renders of all pixels.
  const pt::Goldens& goldens() const { return goldens_; }

  // The square of the bias of two independent pictures of each `step`-th pixel, pixel by pixel.
  std::vector<double> products(const std::vector<double>& a, const std::vector<double>& b,
                               std::size_t step) const;

 private:
  void look_at_bounces(int bounces, const std::function<void(double)>& announce,
                       const Reference& reference);
  // The processor seconds that all threads together get in these seconds by the clock.
  double cpu_seconds_in(double seconds) const;
  std::vector<PixelAt> every(std::size_t step) const;  // each `step`-th pixel; 0 means 1
  pt::RenderSettings next_render(int samples);
  pt::View view_of(const Way& way, int light_samples) const;
  // An even number of samples per pixel that takes this long by the wall clock, if a render of some
  // pixels takes `cpu_seconds`.
  using Cost = std::function<double(const pt::RenderSettings&, std::span<const PixelAt>)>;
  int samples_in(double seconds, const Cost& cpu_seconds);
  int samples_in(double seconds, const pt::View& view);
  // The results of measure() and measure_apart(). Their time is counted.
  RenderedPixels made(const pt::View& view, const pt::RenderSettings& settings,
                      std::span<const PixelAt> pixels);
  MeasuredApart made_apart(const pt::View& view, const pt::RenderSettings& settings,
                           std::span<const pt::BounceRange> ranges,
                           std::span<const PixelAt> pixels);
  void advance(double cpu_seconds, double seconds);

  pt::View view_;
  int threads_;
  std::uint64_t seed_;
  StudyLimits limits_;
  std::function<void(double)> progress_;
  double cpu_seconds_ = 0;
  double seconds_ = 0;   // the same renders by the clock
  double expected_ = 0;  // by the clock, for everything; 0: not known yet
  std::vector<PixelAt> pixels_;
  bool has_reference_;
  pt::Goldens goldens_;  // two independent means of each pixel, with all bounces
  std::vector<Uncertain> bias2_;
};

}  // namespace measure::scene
