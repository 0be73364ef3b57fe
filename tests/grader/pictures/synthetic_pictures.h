#pragma once

#include "grader/pictures/statistics/image_verdict.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

// Pictures drawn from known distributions, without a renderer: like pictures of a right program, or
// of a program with a known error.

namespace grader::pictures {

// The distribution of the samples of the direct light.
enum class Spread {
  diffuse,      // relative deviation 0.3 to 3
  fireflies,    // the same, but one sample in a thousand is some thirty times as bright
  mostly_zero,  // all but 1 % to 50 % are zero
};

// A sample of a pixel is direct * X + indirect * Y, X and Y independent with mean 1. Y has no
// fireflies.
struct SyntheticPixel {
  pt::Rgb direct;
  pt::Rgb indirect;
  double shape = 1;       // of the gamma distribution of nonzero values: variance 1 / shape
  double hit = 1;         // probability that X, or Y, is not zero (mostly_zero)
  bool constant = false;  // X = Y = 1
};

struct SyntheticScene {
  int width = 0;
  int height = 0;
  Spread spread = Spread::diffuse;
  std::vector<SyntheticPixel> pixels;
};

// A floor with two shadows, a background, and a light in view; the last two are constant.
SyntheticScene synthetic_scene(Spread spread, int width, int height);

// Draws pictures of a scene.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  // The means of `samples` samples per pixel, with their exact distribution.
  pt::Image image(const SyntheticScene& scene, int samples);
  Batches batches(const SyntheticScene& scene, int batches, int samples);
  // Its variance is the variance of the drawn samples.
  pt::Film golden(const SyntheticScene& scene, int samples);

  std::mt19937_64& random() { return random_; }

 private:
  struct Sums {
    double x = 0, xx = 0;  // of the samples and their squares
  };
  struct Moments {
    double mean = 0, variance = 0;
  };
  static Moments moments(const Sums& sums, int samples);
  double gamma(double shape, double count);
  int hits(int samples, double probability);
  Sums lit(const SyntheticPixel& pixel, int count);
  Sums light(const SyntheticPixel& pixel, Spread spread, int samples);
  Sums indirect(const SyntheticPixel& pixel, Spread spread, int samples);

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

// The rounds of a submission that renders `scene`.
RenderRound submission(const SyntheticScene& scene, std::uint64_t seed);

// A mistake that a program could make, and its picture.
struct SyntheticError {
  std::string name;
  std::function<void(SyntheticScene&)> make;
};

// 1 % too much energy; 10 % too dark in a block of 2 % of the picture; a shadow missing on 1 % of
// it; indirect light 5 % low; one bounce too few.
std::vector<SyntheticError> synthetic_errors();

SyntheticScene with(SyntheticScene scene, const SyntheticError& error);

}  // namespace grader::pictures
