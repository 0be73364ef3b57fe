#pragma once

#include "pt/image/film.h"

#include <array>
#include <vector>

// Mean and variance of the samples of every pixel, gathered picture by picture.

namespace grader::pictures {

struct PixelMoments {
  double samples = 0;
  std::array<double, 4> mean{};     // r, g, b, luminance
  std::array<double, 4> squares{};  // sums of (value - mean)^2
};

// The moments of all samples of a film's pixel; one_sample() takes the pixel's mean as a single sample, for
// pixels whose number of samples depends on their values.
PixelMoments moments_of(const pt::FilmPixel& pixel);
PixelMoments one_sample(const pt::FilmPixel& pixel);

// The moments of both sets of samples together (Chan, Golub and LeVeque 1979). If all samples are equal, the squares
// stay exactly zero.
PixelMoments merge(const PixelMoments& a, const PixelMoments& b);

pt::FilmPixel film_pixel(const PixelMoments& moments);

}  // namespace grader::pictures
