#pragma once

#include "writeup/accuracy/journal.h"
#include "writeup/accuracy/model.h"
#include "writeup/accuracy/pixels_apart.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace writeup::accuracy {

// The way to follow light: all settings but the numbers of samples.
struct Way {
  pt::PathSettings::Direct direct = pt::PathSettings::Direct::lights;
  int bounces = 5;
  double survival = 0.7;

  bool operator==(const Way&) const = default;
};

pt::PathSettings path_of(const Way& way, int light_samples);

// A number that was measured, and its standard error.
struct Uncertain {
  double value = 0;
  double error = 0;
};

// The mean of some numbers, and its error from how they spread.
Uncertain mean_of(const std::vector<double>& values);

// Short renders of one way: the cost and the noise of each.
struct Tried {
  int light_samples = 1;
  Uncertain variance;  // of one camera sample, relative
  Uncertain seconds;   // of processor time, for one camera sample
  Uncertain bias2;     // the square of the relative bias, by these renders alone
  double rays = 0;     // for one camera sample
};

// A picture that was made with the numbers that were found, on some of the pixels.
struct Checked {
  Uncertain error;     // root of relMSE
  double seconds = 0;  // of processor time, per pixel
  double samples = 0;  // per pixel
  double rays = 0;     // per pixel
  std::size_t pixels = 0;
};

// The most bounces that are told apart. All later ones are one rest.
inline constexpr int kToldApart = 16;
inline constexpr int kMaxWithoutTree = 30000;  // surfaces: more are not tried one by one
inline constexpr int kAllBounces = 100;        // as trace_path takes them

// The limits of a study.
struct StudyLimits {
  double seconds = 45;  // by the wall clock, what all of it may take, about
  int samples = 0;      // per pixel of each render, even; 0: as many as there is time for
  int pixels = 10000;   // that are looked at, about
};

// A view whose settings are looked for. All renders are of the same pixels, and each has random
// numbers of its own.
class Study {
 public:
  // `progress` is called with the part of the time that has been used. `bounces`: of the picture that
  // errors are measured against, at most kToldApart, or kAllBounces.
  Study(const pt::View& view, int threads, std::uint64_t seed, const StudyLimits& limits,
        std::function<void(double)> progress, int bounces = kAllBounces, Journal journal = {});

  // The time of all renders so far.
  double cpu_seconds() const { return cpu_seconds_; }
  // The run has ended as it should: it will not have to go on.
  void forget_journal() { journal_.remove(); }

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
    double relative = 0;     // v / (g + .01)^2, of which relMSE is made
    double over_square = 0;  // v / g^2, by which adaptive sampling judges
  };
  std::vector<PixelNoise> pixel_noise(const Way& way, int light_samples);

  // The picture with these settings, made twice, of as many pixels as there is time for; `seconds` is
  // what one of them takes, about. Its error is seen in two ways, of which the more certain is taken:
  // against the long renders; and as half the square of the difference of the two pictures, plus
  // `bias2`. It may take this part of the time.
  Checked check(const pt::PathSettings& path, const pt::RenderSettings& settings, double seconds,
                double bias2, double part = 0.08);

  // The time of the same picture with the tracer of `other`, over the usual time: both render in
  // turns.
  Uncertain times_as_long(const pt::Scene& other, const Way& way, int light_samples);

  // 1 / (g + .01)^2 of each pixel, of which relMSE is made.
  const std::vector<double>& weights() const { return weight_; }

  // (a - g)(b - g') / (g + .01)^2 of each `step`-th pixel, for two goldens g and g': its mean is
  // relMSE if a and b are the same picture, and the square of the bias if they are independent.
  std::vector<double> products(const std::vector<double>& a, const std::vector<double>& b,
                               std::size_t step) const;

 private:
  void look_at_bounces(int bounces);
  std::vector<PixelAt> every(std::size_t step) const;  // of the pixels; 0 as 1
  pt::RenderSettings next_render(int samples);
  pt::View view_of(const Way& way, int light_samples) const;
  // An even number of samples per pixel that takes so long by the wall clock, where `cpu_seconds` is
  // what a render of some pixels takes.
  using Cost = std::function<double(const pt::RenderSettings&, std::span<const PixelAt>)>;
  int samples_in(double seconds, const Cost& cpu_seconds);
  int samples_in(double seconds, const pt::View& view);
  // The results of measure() and measure_apart(), from the journal if it has them.
  RenderedPixels made(const pt::View& view, const pt::RenderSettings& settings,
                      std::span<const PixelAt> pixels);
  MeasuredApart made_apart(const pt::View& view, const pt::RenderSettings& settings,
                           std::span<const pt::BounceRange> ranges,
                           std::span<const PixelAt> pixels);
  void keep(const std::string& question, const std::vector<double>& answer);
  void advance(double cpu_seconds);

  pt::View view_;
  int threads_;
  std::uint64_t seed_;
  StudyLimits limits_;
  std::function<void(double)> progress_;
  Journal journal_;
  double cpu_seconds_ = 0;
  std::vector<PixelAt> pixels_;
  std::vector<double> golden_[2];  // two independent means of each pixel, with all bounces
  std::vector<double> weight_;     // 1 / (g + .01)^2
  std::vector<Uncertain> bias2_;
};

// The model that the renders give. Their way's bias goes with it.
SampleModel model_of(const std::vector<Tried>& tried, double bias2);

}  // namespace writeup::accuracy
