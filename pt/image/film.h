#pragma once

#include "pt/image/image.h"
#include "pt/math/rgb.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace pt {

// The mean and the variances of the samples of one pixel. The variances are those of one sample,
// unbiased; the variance of `mean` is variance / samples. The variance of luminance is separate,
// because it depends on how the channels vary together.
struct FilmPixel {
  Rgb mean;
  Rgb variance;           // 0 where samples < 2
  double variance_y = 0;  // of luminance()
  int samples = 0;        // 0: the number and the variances are not known
};

// A render with its statistics. Row 0 is the TOP row, as in Image.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<FilmPixel> pixels;  // width * height, row by row

  Film() = default;
  Film(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h) {}

  const FilmPixel& at(int x, int y) const { return pixels[index(x, y)]; }
  // Different pixels may be set from different threads.
  void set(int x, int y, const FilmPixel& pixel) { pixels[index(x, y)] = pixel; }

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return static_cast<std::size_t>(y) * width + x;
  }
};

inline Image mean(const Film& film) {
  Image image(film.width, film.height);
  for (std::size_t i = 0; i < film.pixels.size(); ++i) image.pixels[i] = film.pixels[i].mean;
  return image;
}

// Mean and variance of the samples of a pixel, one at a time (Welford 1962): the variance of equal
// samples is exactly zero, and a large mean costs it no digits.
class RunningMoments {
 public:
  void add(Rgb sample) {
    const std::array<double, 4> values{sample.r, sample.g, sample.b, luminance(sample)};
    ++samples_;
    for (int i = 0; i < 4; ++i) {
      const double step = values[i] - mean_[i];
      mean_[i] += step / samples_;
      squares_[i] += step * (values[i] - mean_[i]);
    }
  }

  int samples() const { return samples_; }
  Rgb mean() const { return {mean_[0], mean_[1], mean_[2]}; }
  double mean_y() const { return mean_[3]; }
  // The variance of one sample, divided by n - 1; 0 for n < 2.
  Rgb variance() const { return {variance(0), variance(1), variance(2)}; }
  double variance_y() const { return variance(3); }

  FilmPixel pixel() const { return {mean(), variance(), variance_y(), samples_}; }

 private:
  double variance(int i) const { return samples_ < 2 ? 0 : squares_[i] / (samples_ - 1); }

  int samples_ = 0;
  std::array<double, 4> mean_{};     // r, g, b, Y
  std::array<double, 4> squares_{};  // sums of (value - mean)^2
};

}  // namespace pt
