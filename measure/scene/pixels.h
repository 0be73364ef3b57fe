#pragma once

#include "pt/render/render_film.h"

#include <span>
#include <string>
#include <vector>

namespace measure::scene {

// A pixel of a view, counted as in the tasks: from the left and from the bottom.
struct PixelAt {
  int x = 0;
  int y = 0;
};

// About `wanted` pixels, or all pixels if there are fewer: one per block of a grid, at a place that
// depends on `seed`. Their mean is an estimate of the picture's mean.
std::vector<PixelAt> spread_pixels(int width, int height, int wanted, std::uint64_t seed);

// Renders pixels with one of two implementations; a program links one of them:
//   here   (pixels_here.cpp), by the tasks linked into this program;
//   boxed  (boxed_main.cpp), by the worker of a submission, in its box: one thread.

// The results of some pixels, all in luminance.
struct RenderedPixels {
  std::vector<double> mean;      // of each pixel
  std::vector<double> variance;  // of one sample, unbiased, for each pixel
  std::vector<int> samples;      // of each pixel
  double cpu_seconds = 0;        // of all threads
  long long rays = 0;

  long long all_samples() const;
};
RenderedPixels measure(const pt::View& view, const pt::RenderSettings& settings,
                       std::span<const PixelAt> pixels);

// The tasks that were called so far but are not written yet.
std::vector<std::string> unwritten_tasks();

}  // namespace measure::scene
