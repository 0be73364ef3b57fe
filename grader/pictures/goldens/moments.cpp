#include "grader/pictures/goldens/moments.h"

#include <cmath>

namespace grader::pictures {

PixelMoments one_sample(const pt::FilmPixel& pixel) {
  return {1, {pixel.mean.r, pixel.mean.g, pixel.mean.b, luminance(pixel.mean)}, {}};
}

PixelMoments moments_of(const pt::FilmPixel& pixel) {
  PixelMoments moments = one_sample(pixel);
  moments.samples = pixel.samples;
  const double degrees = pixel.samples - 1;
  moments.squares = {degrees * pixel.variance.r, degrees * pixel.variance.g,
                     degrees * pixel.variance.b, degrees * pixel.variance_y};
  return moments;
}

PixelMoments merge(const PixelMoments& a, const PixelMoments& b) {
  PixelMoments sum;
  sum.samples = a.samples + b.samples;
  if (sum.samples == 0) return sum;
  const double part = b.samples / sum.samples;
  for (int i = 0; i < 4; ++i) {
    const double step = b.mean[i] - a.mean[i];
    sum.mean[i] = a.mean[i] + part * step;
    sum.squares[i] = a.squares[i] + b.squares[i] + a.samples * part * step * step;
  }
  return sum;
}

pt::FilmPixel film_pixel(const PixelMoments& moments) {
  const auto variance = [&](int i) {
    return moments.samples < 2 ? 0 : moments.squares[i] / (moments.samples - 1);
  };
  return {{moments.mean[0], moments.mean[1], moments.mean[2]},
          {variance(0), variance(1), variance(2)},
          variance(3),
          static_cast<int>(std::lround(moments.samples))};
}

}  // namespace grader::pictures
