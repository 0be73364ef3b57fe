#pragma once

#include "writeup/accuracy/options.h"
#include "writeup/accuracy/study.h"

#include <optional>
#include <string>
#include <vector>

namespace writeup::accuracy {

// One way to make the picture, with more and more samples.
struct Method {
  std::string title;
  Way way;
  int light_samples = 1;
  bool adaptive = false;  // more accurate by a smaller tolerance, not by more samples
};

// Its pictures, from few samples to many.
struct Curve {
  Method method;
  std::vector<Checked> points;
  Uncertain slope;           // of log error over log samples; -1/2 where samples are independent
  Uncertain error2_second;   // error^2 x seconds per pixel: the same for every number of samples
  bool heavy_tails = false;  // the variance itself is known badly: a few samples make most of it
};

std::vector<Curve> find_curves(Study& study, const pt::Scene& scene, int bounces);

// The slope of log error over log samples of these points, by least squares.
Uncertain slope_of(const std::vector<Checked>& points);

std::string to_text(const std::vector<Curve>& curves, const Options& options);

// converge.csv, and three charts where there is gnuplot: error over samples, seconds and rays.
void write_curves(const std::vector<Curve>& curves, const Options& options,
                  const std::filesystem::path& folder);

}  // namespace writeup::accuracy
