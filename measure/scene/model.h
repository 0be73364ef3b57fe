#pragma once

#include <optional>
#include <span>

// A model of the error and the time of a picture, from their parts. Errors are relative: the root
// of relMSE, which is the mean of (x - g)^2 / (g + .01)^2 over all pixels, in luminance.

namespace measure::scene {

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

// The number of light samples at which time x variance is least: sqrt(B c0 / (A c1)), between 1 and
// `most`; not whole.
double best_light_samples(const SampleModel& model, int most);

// Numbers of samples, and the predictions for them.
struct Choice {
  int light_samples = 1;
  int samples = 1;
  double error = 0;    // root of relMSE
  double seconds = 0;  // of processor time, per pixel
};

inline constexpr int kMaxLightSamples = 100;  // as in trace_path
inline constexpr int kMaxSamples = 1 << 24;   // as in ./run render
inline constexpr int kFewestSamples = 2;      // one goes through the centre of the pixel

// The numbers that reach the error in the least time; nothing if none can.
std::optional<Choice> cheapest_choice(const SampleModel& model, double error);
// The same for a given number of light samples.
std::optional<Choice> cheapest_choice_with(const SampleModel& model, double error,
                                           int light_samples);

}  // namespace measure::scene
