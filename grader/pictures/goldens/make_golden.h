#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "pt/image/film.h"
#include "pt/image/sample_map.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// Renders goldens with the linked tasks, part by part.

namespace grader::pictures {

// Mean and variance of the samples of every pixel, gathered picture by picture.

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

// The amount of work for a recipe: `parts` pictures, each with its own seed and this number of
// samples per pixel. For an adaptive recipe each part is a run.
struct Effort {
  int parts = 16;
  int samples = 256;
};

// 4096 samples per pixel, 16384 for a noisy recipe, 256 runs for an adaptive recipe: at least 64
// times the samples of a verdict's first round, and 16 times those of the last.
Effort usual_effort(const Recipe& recipe);

// The sum of all parts so far.
struct GoldenState {
  std::string hash;  // of the recipe's picture, and of the program that renders it
  int samples = 0;   // per part
  int parts = 0;     // number of them so far
  double cpu_seconds = 0;
  std::vector<PixelMoments> pixels;      // row 0 is the top row
  std::vector<std::vector<int>> counts;  // for an adaptive recipe, per run; as `pixels`
};

// Continues the state in `partial`, if it has the same picture, effort and program, and saves it
// there after every part. `progress` gets the part done, in [0, 1]. Throws pt::Error if a sample is
// not finite.
GoldenState render_golden(const Recipe& recipe, const Effort& effort, int threads,
                          const std::filesystem::path& partial,
                          const std::function<void(double)>& progress);

// For an adaptive recipe: 1 for each pixel whose first batch was all zero in one of the runs.
std::vector<char> dark_starts(const Recipe& recipe, int runs, int threads);

pt::Film film_of(const Recipe& recipe, const GoldenState& state);
std::vector<pt::SampleMap> maps_of(const Recipe& recipe, const GoldenState& state);

}  // namespace grader::pictures
