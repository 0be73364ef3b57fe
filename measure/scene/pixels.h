#pragma once

#include "pt/error.h"
#include "pt/render/render_film.h"
#include "pt/scene/bounce_range.h"

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

// The bounces of the linked trace_path, or of a submission's, do not add up to what it returns.
struct NotApart : pt::Error {
  using pt::Error::Error;
};

// The mean of each pixel (inner) in each range of bounces (outer), from the same paths. Throws NotApart.
struct MeasuredApart {
  std::vector<std::vector<double>> mean;
  double cpu_seconds = 0;
};
MeasuredApart measure_apart(const pt::View& view, const pt::RenderSettings& settings,
                            std::span<const pt::BounceRange> ranges,
                            std::span<const PixelAt> pixels);

}  // namespace measure::scene
