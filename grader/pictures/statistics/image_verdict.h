#pragma once

#include "grader/results/results.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

// Decides whether a picture made of random samples agrees with the golden, by statistics whose error rates
// are known: docs/verdicts.md says what is compared, how often a right picture fails, and which
// mistakes are found. Linear radiance; pixels count from the top left, as in pt::Image.

namespace grader::pictures {

// The number of samples of a recipe: `noisy` is for pictures in which few samples carry the light.
enum class NoiseClass { ordinary, noisy };

// One round renders `batches` pictures, each with `samples` samples per pixel.
struct Round {
  int batches = 16;  // >= 2
  int samples = 4;   // >= 1
};

// 64, 128 and 256 samples per pixel in all; 256, 512 and 1024 for a noisy picture. The golden needs
// 16 times the samples of the last round.
std::array<Round, 3> rounds_of(NoiseClass noise);

// In an adaptive picture a sample is one whole run: the golden then holds the mean and the variance
// between the reference's runs, and `samples` counts those runs. A run has a hundred samples per pixel
// and more, so that six of them say more than the first round of another picture.
inline constexpr std::array<Round, 3> kAdaptiveRounds{{{6, 1}, {8, 1}, {16, 1}}};

// The chance that a right picture has a failing cell in each round, all cells together.
inline constexpr std::array<double, 3> kRoundLevels{1e-2, 2e-3, 2e-3};

// The number of failing cells of the first round that are tested again in the others.
inline constexpr std::size_t kKeptCells = 16;

// A block that is off by this much, relative to the golden, is wrong even in a noisy picture: so
// much noise would show in the whole picture's energy.
inline constexpr double kBlatant = 0.2;

struct Batches {
  int samples = 0;                // per pixel, of each image
  std::vector<pt::Image> images;  // at least 2, independent of each other
};

// Renders a round (1..3) with samples that no other round and no golden uses. Its exceptions pass
// through judge_image.
using RenderRound = std::function<Batches(int round, int batches, int samples)>;

struct ImageVerdict {
  enum class Outcome {
    pass,
    wrong,
    too_noisy,  // right on average, as far as the noise shows
    unusable,   // not finite, negative, of another size, or samples that repeat themselves
  };
  Outcome outcome = Outcome::pass;
  int rounds = 0;        // number of rendered rounds
  int samples = 0;       // per pixel, all rounds together
  std::string sentence;  // the fault, for a person; empty if it passes
  double noise = 0;      // variance of a sample over the golden's, mean over the pixels; last round
  // The smallest failing cells, at most 16. A cell as large as the picture is the whole picture. Errors
  // are relative to the golden's mean there, or to 1/1000 of the whole golden's if that is more.
  std::vector<results::FailingCell> cells;
  // Mean and variance of one sample over all rounds, the variance from the batches. Pixels that are
  // not finite are black. Empty (0 x 0) if an image had another size.
  pt::Film render;
  // For each pixel the largest |z| over its threshold in the last round, of the pixel, its blocks,
  // or its constant; at most 1000, the same in all channels. The sums over the whole picture do not
  // count. Empty if `render` is.
  pt::Image evidence;
};

// A failing cell counts only if it fails in each round, with the same sign. Rounds after the first
// are rendered only while a failing cell is left. max_rounds = 1 is for a picture that is known to
// be wrong from elsewhere: the first round's failing cells count, and a right picture may fail once
// in a hundred. `most_noise`: the variance of a sample that a right submission may have, over the
// golden's; 0 for the usual limit of the class, 3 or 6. Precondition: the golden has pixels, each
// with samples >= 2; 1 <= max_rounds <= 3.
ImageVerdict judge_image(const pt::Film& golden, NoiseClass noise, const RenderRound& render,
                         int max_rounds = 3, double most_noise = 0);

// The same with other rounds, such as kAdaptiveRounds.
ImageVerdict judge_image(const pt::Film& golden, NoiseClass noise, const RenderRound& render,
                         int max_rounds, const std::array<Round, 3>& rounds, double most_noise = 0);

// The cells in which two goldens of one recipe, with independent samples, cannot both be right.
// Empty if they agree; two right goldens disagree less than once in a million times. off_by is the
// newer golden's, relative to the older. Throws pt::Error if their sizes differ.
std::vector<results::FailingCell> contradictions(const pt::Film& older, const pt::Film& newer);

}  // namespace grader::pictures
