#pragma once

#include "bench/cycles.h"
#include "bench/regions.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// A view rendered by several renderers: whether their pictures agree, and the error of each after so many seconds.

namespace pt {

// The effort of the comparison.
struct Effort {
  int golden_renders = 16;  // even; each with a seed of its own
  int golden_samples = 64;
  std::vector<int> samples{4, 16, 64, 256};
  int repeats = 2;         // renders of each number of samples
  std::uint32_t seed = 1;  // of the first render; the others take the seeds after it
};

// One renderer with its settings.
struct Contender {
  std::string title;
  std::function<TimedImage(int samples, std::uint32_t seed)> render;
};

// A mean over renders that differ in their seed, and its standard error.
struct Mean {
  double value = 0;
  double error = 0;
};
Mean mean_of(const std::vector<double>& values);

// A renderer's long render: the mean of many, the two means of half of them each, and the mean luminance of each region.
struct LongRender {
  Image picture;
  std::vector<double> halves[2];  // luminance, by pixel
  std::vector<Mean> regions;
};

// The error of a picture of `samples` samples. Errors are roots of relMSE, the mean over the pixels of
// (x - g)^2 / (g + .01)^2 of luminance, without the part that is the noise of g.
struct ErrorAfter {
  int samples = 0;
  double cpu_seconds = 0;    // the median of the repeats, without what does not depend on samples
  std::vector<Mean> errors;  // against each golden
};

struct ErrorCurve {
  std::vector<ErrorAfter> points;
  double fixed_seconds = 0;  // of a render, besides its samples
};

struct RendererComparison {
  std::vector<LongRender> goldens;
  std::vector<ErrorCurve> curves;  // of each contender
};

// All contenders by turns; seeds differ everywhere. `golden_of`: the contenders whose goldens are made. `progress`
// is called with the part that is done.
RendererComparison compare(const std::vector<Contender>& contenders,
                           const std::vector<int>& golden_of, const std::vector<Region>& regions,
                           const Effort& effort, const std::function<void(double)>& progress);

}  // namespace pt
