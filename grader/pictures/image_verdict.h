#pragma once

#include "grader/results/results.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

// Whether a picture made of random samples is the golden's, by statistics whose error rates are
// known: docs/verdicts.md says what is compared, how often a right picture fails, and which
// mistakes are found. Linear radiance; pixels count from the top left, as in pt::Image.

namespace grader::pictures {

// How many samples a recipe needs: `noisy` for pictures in which few samples carry the light.
enum class NoiseClass { ordinary, noisy };

// What one stage asks for: `batches` pictures, each with `samples` samples a pixel.
struct Stage {
  int batches = 16;  // >= 2
  int samples = 4;   // >= 1
};

// 64, 128 and 256 samples a pixel in all; 256, 512 and 1024 for a noisy picture. The golden needs
// 16 times the samples of the last.
std::array<Stage, 3> stages_of(NoiseClass noise);

// Of an adaptive picture a sample is one whole run: the golden then holds the mean and the variance
// between the reference's runs, and `samples` counts those runs.
inline constexpr std::array<Stage, 3> kAdaptiveStages{{{16, 1}, {16, 1}, {16, 1}}};

// How often a right picture may be complained of in each stage, all cells together.
inline constexpr std::array<double, 3> kStageLevels{1e-2, 2e-3, 2e-3};

// So many complaints of the first stage go on to the others.
inline constexpr std::size_t kKeptComplaints = 16;

// A block that is so far off, relative to the golden, is wrong however noisy the picture is: noise
// that hides as much would show in the whole picture's energy.
inline constexpr double kBlatant = 0.2;

struct Batches {
  int samples = 0;                // a pixel, of each image
  std::vector<pt::Image> images;  // at least 2, independent of each other
};

// Renders a stage (1..3) with samples that no other stage and no golden took. May throw:
// judge_image lets it through.
using RenderStage = std::function<Batches(int stage, int batches, int samples)>;

struct ImageVerdict {
  enum class Outcome {
    pass,
    wrong,
    too_noisy,  // right on average, as far as the noise lets one see
    unusable,   // not finite, negative, of another size, or samples that repeat themselves
  };
  Outcome outcome = Outcome::pass;
  int stages = 0;        // that were rendered
  int samples = 0;       // a pixel, all stages together
  std::string sentence;  // what is wrong, for a person; empty if it passes
  double noise = 0;      // variance of a sample over the golden's, mean over the pixels; last stage
  // The smallest that fail, at most 16. A cell as large as the picture stands for all of it.
  // Relative to the golden's mean there, or to 1/1000 of the whole golden's where that is more.
  std::vector<results::FailingCell> cells;
  // Mean and variance of one sample over all stages, the variance had from the batches. Pixels that
  // are not finite are black; empty (0 x 0) if an image was of another size.
  pt::Film render;
  // The largest |z| over its threshold of the pixel, the blocks or the constant that the pixel is
  // part of, in the last stage; at most 1000, all channels the same. The sums over the whole
  // picture take no part. Empty like `render`.
  pt::Image evidence;
};

// A complaint counts only if each stage repeats it, with the same sign. Stages after the first are
// rendered only while a complaint is left. max_stages = 1 is for a picture that is known to be
// wrong from elsewhere: the first stage's complaint counts, and a right picture may fail once in a
// hundred. `most_noise`: the variance of a sample that a right submission may have, over the
// golden's; 0 for the usual limit of the class, 3 or 6. Precondition: the golden has pixels, each
// with samples >= 2; 1 <= max_stages <= 3.
ImageVerdict judge_image(const pt::Film& golden, NoiseClass noise, const RenderStage& render,
                         int max_stages = 3, double most_noise = 0);

// The same with stages of one's own, as kAdaptiveStages.
ImageVerdict judge_image(const pt::Film& golden, NoiseClass noise, const RenderStage& render,
                         int max_stages, const std::array<Stage, 3>& stages, double most_noise = 0);

// Where two goldens of one recipe, of independent samples, cannot both be right; empty if they
// agree, which two right ones fail to do less than once in a million times. off_by is the newer's,
// relative to the older. Throws pt::Error if their sizes differ.
std::vector<results::FailingCell> contradictions(const pt::Film& older, const pt::Film& newer);

}  // namespace grader::pictures
