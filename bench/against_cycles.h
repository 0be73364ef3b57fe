#pragma once

#include "bench/cycles.h"
#include "bench/regions.h"
#include "pt/math/uncertain.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Compares several renderers on one view: their pictures, and the error of each against time.

namespace pt {

// The effort of the comparison.
struct Effort {
  int golden_renders = 16;  // even; each with a seed of its own
  int golden_samples = 64;
  std::vector<int> samples{4, 16, 64, 256};
  int repeats = 2;         // renders per number of samples
  std::uint32_t seed = 1;  // for the first render; the others use the seeds after it
};

// One renderer with its settings.
struct Contender {
  std::string title;
  std::function<TimedImage(int samples, std::uint32_t seed)> render;
};

// A renderer's long render: the mean of many renders, the mean of each half of them, and each region's mean luminance.
struct LongRender {
  Image picture;
  std::vector<double> halves[2];  // luminance, by pixel
  std::vector<Uncertain> regions;
};

// The error of a picture of `samples` samples: the root of relMSE, the mean over the pixels of (x -
// g)^2 / (g + d)^2 in luminance (d: pt::dark_of), without the noise of g.
struct ErrorAfter {
  int samples = 0;
  double cpu_seconds = 0;         // the median of the repeats, without the fixed time
  std::vector<Uncertain> errors;  // against each golden
};

struct ErrorCurve {
  std::vector<ErrorAfter> points;
  double fixed_seconds = 0;  // per render, without its samples
};

struct RendererComparison {
  std::vector<LongRender> goldens;
  std::vector<ErrorCurve> curves;  // one per contender
};

// The contenders take turns, and no two renders have the same seed. `golden_of` lists the contenders whose goldens
// are made. `progress` is called with the part that is done.
RendererComparison compare(const std::vector<Contender>& contenders,
                           const std::vector<int>& golden_of, const std::vector<Region>& regions,
                           const Effort& effort, const std::function<void(double)>& progress);

}  // namespace pt
