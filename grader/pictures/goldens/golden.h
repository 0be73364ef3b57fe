#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <array>
#include <string>
#include <vector>

// A golden and a submission's batches as planes of numbers, with which the tests of a picture
// compute.

namespace grader::pictures {

// Red, green, blue, luminance.
inline constexpr int kPlanes = 4;
inline constexpr int kLuminance = 3;

using Plane = std::vector<double>;  // a value per pixel, row by row
using Planes = std::array<Plane, kPlanes>;

inline double value(const pt::Rgb& color, int plane) {
  return plane == kLuminance ? luminance(color) : color[plane];
}

struct Golden {
  int width = 0;
  int height = 0;
  Planes mean;
  Planes variance;                      // of one sample
  Plane samples;                        // per pixel
  std::array<double, kPlanes> scale{};  // the brightness to compare with: the mean over all pixels
  std::vector<char> constant;           // pixels whose samples are all alike
  Plane plain;                          // weights: 1, and 0 for constant pixels
  Plane weighted;  // weights that favour the best known pixels, by their neighbours; 0 if constant
};

// Reads the golden of a recipe, as `bless` writes it. Throws pt::Error if it is missing or has another size.
pt::Film read_golden(const std::string& path, const Recipe& recipe);

Golden prepare(const pt::Film& film);

// The batches of one round.
struct Moments {
  int batches = 0;
  int samples = 0;  // per pixel, of each batch
  Planes mean;
  Planes variance;  // between the batches, unbiased
};

// Precondition: at least two images, all of one size.
Moments moments(const std::vector<pt::Image>& images, int samples);

// Two pictures, and the known variances of their difference.
struct Comparison {
  const Golden& golden;
  Planes difference;    // of the means
  Planes own;           // from the judged picture's own batches
  Planes expected;      // from the golden's variance
  Planes golden_error;  // the golden's own
};

Comparison compare(const Golden& golden, const Moments& round);

}  // namespace grader::pictures
