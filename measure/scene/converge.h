#pragma once

#include "measure/scene/options.h"
#include "measure/scene/study.h"
#include "pt/scene/tracer.h"

#include <optional>
#include <string>
#include <vector>

namespace measure::scene {

// One way to make the picture, with more and more samples.
struct Method {
  std::string id;  // short, for the names of numbers: "l4"
  std::string title;
  Way way;
  int light_samples = 1;
  bool adaptive = false;             // a smaller tolerance, not more samples, adds accuracy
  std::optional<pt::Engine> engine;  // if not the engine of the study
};

// A method's pictures, from few samples to many.
struct MethodCurve {
  Method method;
  std::vector<Checked> points;
  Uncertain slope;           // of log error over log samples; -1/2 where samples are independent
  Uncertain error2_second;   // error^2 x seconds per pixel: the same for every number of samples
  Uncertain error2_ray;      // error^2 x rays per pixel
  Uncertain error2_sample;   // error^2 x samples per pixel
  bool heavy_tails = false;  // a few samples make most of the variance: it is uncertain
  // No number of samples helps: most of the last error is light that the method never finds.
  bool fails = false;
};

// The methods that make sense in a scene. The first is light sampling with l = 1.
std::vector<Method> methods_in(const pt::Scene& scene, int bounces, pt::Engine engine);

// Throws pt::Error if the title is not empty and not that of a method.
void expect_method(const std::vector<Method>& methods, const std::string& title);

// A curve for each method that is written. The curves of engines have the errors of the first
// curve, and their own times.
std::vector<MethodCurve> find_curves(Study& study, const pt::View& view,
                                     const std::vector<Method>& methods);

// The slope of log error over log samples of these points, by least squares.
Uncertain slope_of(const std::vector<Checked>& points);

// One method compared with another.
struct Factors {
  Uncertain time;   // the ratio of times for the same error
  Uncertain error;  // the ratio of errors after the same time
  Uncertain rays;   // the ratio of rays for the same error
};
Factors factors(const MethodCurve& curve, const MethodCurve& beside);

// The method with the least time for the same error, of those that do not fail.
const MethodCurve& fastest(const std::vector<MethodCurve>& curves);

// A place of a method's line in the chart of efficiencies: 1 / (time x error^2), over that of the
// first method. It is the same at all times where the error falls as 1 / sqrt(time), and bends where
// a bias or a pixel that stops too early begins to count.
struct Efficiency {
  double seconds = 0;  // per pixel
  Uncertain value;
};
std::vector<Efficiency> efficiencies(const MethodCurve& curve, const MethodCurve& first);

// A quotient of independent numbers.
Uncertain ratio(const Uncertain& a, const Uncertain& b);

// At most seven curves to draw, each unlike the others: light sampling with l = 1, the cheapest other l
// and the dearest, the cheapest hemisphere sampling, the cheapest other survival, adaptive sampling,
// and the next engine. Each kind has the same colour in all charts.
struct DrawnMethod {
  const MethodCurve* curve;
  const char* color;
};
std::vector<DrawnMethod> seven_of(const std::vector<MethodCurve>& curves);

// The least error that the lines of all methods have after some time. A method's line is straight between
// its points in the logarithms, since it can take any number of samples; a method that fails has no line.
struct FrontPlace {
  double seconds = 0;  // per pixel
  double error = 0;
};
std::vector<FrontPlace> front_of(const std::vector<MethodCurve>& curves);

// The tolerances, or numbers of samples, of a curve's points.
inline constexpr int kSamples[] = {4, 16, 64, 256};
// Above .3, nearly all pixels of a picture stop after one batch, whatever the tolerance.
inline constexpr double kTolerances[] = {0.3, 0.2, 0.14, 0.1};
inline constexpr int kMaxAdaptive = 4096;
inline constexpr int kBatch = 16;

// A table for a terminal, relative to options.beside.
std::string to_text(const std::vector<MethodCurve>& curves, const Options& options);

// Writes into options.out: converge.csv, factors.csv (each method relative to each other),
// converge.json, and with gnuplot three charts: error over samples, seconds and rays.
void write_curves(const std::vector<MethodCurve>& curves, const Options& options,
                  double cpu_seconds);

}  // namespace measure::scene
