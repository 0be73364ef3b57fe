#pragma once

#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/view.h"

namespace pt {

struct AdaptiveSettings {
  int max_samples = 64;     // >= batch; it need not be a multiple of batch
  int batch = 32;           // samples between two checks; >= 2
  double tolerance = 0.05;  // relative to the mean; 1e-4 to 1
};

// The mean of a pixel, and how many samples it took.
struct PixelEstimate {
  Rgb mean;
  int samples = 0;
};

// The mean radiance that falls on one pixel, with as many samples as it needs.
//
// In:  as in estimate_pixel; every sample goes through a random point of the pixel.
// Out: the mean of all samples taken, and their number n. After each batch, let mu be the mean and
//      sigma the standard deviation of the luminance of the samples so far. The pixel is done if
//      1.96 sigma / sqrt(n) < tolerance mu: the 95 % interval of the mean is narrow enough. A pixel
//      never takes more than max_samples samples: its last batch may be shorter than the others.
//
// The denominator in sigma may be n or n - 1. If all samples are zero, both sides of the condition
// are zero: < and <= are both right there.
//
// Promises:
//   - stops where the interval is narrow: after the first batch that satisfies the condition,
//     exactly, for any sequence of samples.
//   - checks once a batch: n is a multiple of `batch`, or max_samples.
//   - takes one batch of a constant: if all samples are equal, rounding errors in the variance do
//     not make it go on.
//   - never exceeds the maximum: radiance() is called n times, and 1 <= n <= max_samples.
//   - returns the mean of all samples: divided by n, wherever it stopped.
//   - judges by luminance: not by one channel.
//   - does not stop just because it is dark: unless all samples are zero, a small mean alone does
//     not end a pixel.
//   - uses the batch and the tolerance given: for all allowed values.
//   - passes the settings on: radiance() gets the view's scene and settings, and the caller's
//     sampler, which has moved on afterwards.
//   - covers the whole pixel: all points of the square are equally likely.
//   - forgets the pixel before: the same arguments give the same answer, whatever came before.
//
// Precision: the mean is right to 1e-5 of its size, also with ten thousand samples (a sum of so
// many in single precision is not). If the two sides of the condition differ by less than 2e-5 of
// their size, both decisions are right: so you may use 1.959964 in place of 1.96.
//
// May call: the task camera_ray, radiance(), and functions that a header of pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler);

}  // namespace pt
