#pragma once

#include "pt/math/uncertain.h"

#include <optional>
#include <span>
#include <vector>

// A model of the error and the time of a picture, from their parts. Errors are those of
// pt/image/accuracy.h: roots of relMSE.

namespace measure::scene {

using pt::mean_of;
using pt::Uncertain;

// Short renders with one way: their cost and their noise.
struct Tried {
  int light_samples = 1;
  Uncertain variance;  // relative, per camera sample
  Uncertain seconds;   // of processor time, per camera sample
  Uncertain bias2;     // the square of the relative bias, from these renders alone
  double rays = 0;     // per camera sample
};

// Time x variance of a camera sample: the price of a picture, whatever its error.
Uncertain price(const Tried& tried);

// The number of light samples with the lowest price of those that were measured.
const Tried& cheapest_of(const std::vector<Tried>& tried);

// y = at_zero + slope x.
struct Line {
  double at_zero = 0;
  double slope = 0;

  double at(double x) const { return at_zero + slope * x; }
};

struct LinePoint {
  double x = 0;
  double y = 0;
  double error = 1;  // standard error of y, > 0
};

// A line, and the standard error of its slope.
struct FreeLine {
  Line line;
  double slope_error = 0;
};

// The line through the points with the least sum of squares, each in units of its error. It needs
// two or more points with different x.
FreeLine fit_free_line(std::span<const LinePoint> points);
// The same, among lines without a negative number.
Line fit_line(std::span<const LinePoint> points);

// A camera sample with all settings fixed, except its number of light samples l.
struct SampleModel {
  Line noise;        // its relative variance A + B / l, over 1 / l
  Line seconds;      // its processor time c0 + c1 l, over l
  double bias2 = 0;  // the square of the relative bias, which more samples do not reduce

  double variance(int light_samples) const { return noise.at(1.0 / light_samples); }
};

// The number of light samples at which the model's time x variance is least: sqrt(B c0 / (A c1)),
// between 1 and `most`; not whole.
double best_light_samples(const SampleModel& model, int most);

// The number of light samples that the model finds cheaper than everything measured, by more than
// `by` of the price; nothing if there is none. It is worth a measurement.
std::optional<int> worth_measuring(const std::vector<Tried>& tried, const SampleModel& model,
                                   double by);

// Numbers of samples, and what follows from the measurements with as many light samples.
struct Choice {
  int light_samples = 1;
  int samples = 1;
  double error = 0;     // root of relMSE
  double seconds = 0;   // of processor time, per pixel
  double variance = 0;  // relative, per camera sample
};

inline constexpr int kMaxLightSamples = 100;  // as in trace_path
inline constexpr int kFewestPixels = 300;     // of a check
inline constexpr int kMaxSamples = 1 << 24;   // as in ./run render
inline constexpr int kFewestSamples = 2;      // one goes through the centre of the pixel

// The number of camera samples that reaches the error; nothing if none does.
std::optional<Choice> choice_with(const Tried& tried, double bias2, double error);
// The same with the number of light samples that takes the least time of those that were measured.
std::optional<Choice> cheapest_choice(const std::vector<Tried>& tried, double bias2, double error);

// The model from the measurements, with the bias of their way.
SampleModel model_of(const std::vector<Tried>& tried, double bias2);

}  // namespace measure::scene
