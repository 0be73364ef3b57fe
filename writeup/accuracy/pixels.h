#pragma once

#include "pt/render/render_film.h"

#include <span>
#include <string>
#include <vector>

namespace writeup::accuracy {

// A pixel of a view, as the tasks count: from the left and from the bottom.
struct PixelAt {
  int x = 0;
  int y = 0;
};

// The number of pixels to look at where all would take too long.
inline constexpr int kSpreadPixels = 10000;

// About `wanted` pixels, or all if there are no more: one of each block of a grid, at a place in it
// that `seed` says. Their mean stands for the mean of the picture.
std::vector<PixelAt> spread_pixels(int width, int height, int wanted, std::uint64_t seed);

// Pixels by one of two implementations, of which a program links one:
//   here   (pixels_here.cpp), by the tasks linked into this program;
//   boxed  (pixels_boxed.cpp), by the worker of a submission, in its box: one thread.

// The results of some pixels, all of luminance.
struct RenderedPixels {
  std::vector<double> mean;      // of each pixel
  std::vector<double> variance;  // of one sample, unbiased; of each pixel
  std::vector<int> samples;      // of each pixel
  double cpu_seconds = 0;        // of all threads
  long long rays = 0;

  long long all_samples() const;
};
RenderedPixels measure(const pt::View& view, const pt::RenderSettings& settings,
                       std::span<const PixelAt> pixels);

// The tasks that were called so far and are not written yet.
std::vector<std::string> unwritten_tasks();

}  // namespace writeup::accuracy
