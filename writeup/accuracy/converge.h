#pragma once

#include "pt/scene/tracer.h"
#include "writeup/accuracy/options.h"
#include "writeup/accuracy/study.h"

#include <optional>
#include <string>
#include <vector>

namespace writeup::accuracy {

// One way to make the picture, with more and more samples.
struct Method {
  std::string id;  // short, for names of numbers: "l4"
  std::string title;
  Way way;
  int light_samples = 1;
  bool adaptive = false;             // more accurate by a smaller tolerance, not by more samples
  std::optional<pt::Engine> engine;  // another one than that of the study
};

// Its pictures, from few samples to many.
struct MethodCurve {
  Method method;
  std::vector<Checked> points;
  Uncertain slope;           // of log error over log samples; -1/2 where samples are independent
  Uncertain error2_second;   // error^2 x seconds per pixel: the same for every number of samples
  Uncertain error2_ray;      // error^2 x rays per pixel
  bool heavy_tails = false;  // the variance itself is known badly: a few samples make most of it
};

// The methods that make sense in a scene. The first is light sampling with l = 1.
std::vector<Method> methods_in(const pt::Scene& scene, int bounces, pt::Engine engine);

// Throws pt::Error where the title, if any, is that of no method.
void expect_method(const std::vector<Method>& methods, const std::string& title);

// A curve for each method that is written: those of the engines have the errors of the first, at times
// of their own.
std::vector<MethodCurve> find_curves(Study& study, const pt::View& view,
                                     const std::vector<Method>& methods);

// The slope of log error over log samples of these points, by least squares.
Uncertain slope_of(const std::vector<Checked>& points);

// One method beside another.
struct Factors {
  Uncertain time;   // for the same error: times as long
  Uncertain error;  // at the same time: times as large
  Uncertain rays;   // for the same error: times as many
};
Factors factors(const MethodCurve& curve, const MethodCurve& beside);

// The method with the least time for the same error.
const MethodCurve& fastest(const std::vector<MethodCurve>& curves);

// The tolerances, or numbers of samples, of a curve's points.
inline constexpr int kSamples[] = {4, 16, 64, 256};
inline constexpr double kTolerances[] = {0.8, 0.4, 0.2, 0.1};
inline constexpr int kMaxAdaptive = 4096;
inline constexpr int kBatch = 16;

// A table for a terminal, beside options.beside.
std::string to_text(const std::vector<MethodCurve>& curves, const Options& options);

// Writes into options.out: converge.csv, factors.csv (any method beside any other), converge.json, and three charts where there
// is gnuplot: error over samples, seconds and rays.
void write_curves(const std::vector<MethodCurve>& curves, const Options& options,
                  double cpu_seconds);

}  // namespace writeup::accuracy
