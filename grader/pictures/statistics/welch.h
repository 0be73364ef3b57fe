#pragma once

#include "pt/image/film.h"
#include "pt/image/image.h"

#include <array>
#include <string>
#include <vector>

// The question whether two noisy pictures of one size show the same light is decided by Welch's test of the mean luminance of blocks of several sizes (Welch 1947,
// The generalization of Student's problem when several different population variances are involved).

namespace grader::pictures {

// A picture with the noise of its own luminance.
struct NoisyPicture {
  pt::Image mean;
  std::vector<double> variance;  // of the luminance of `mean`, per pixel
  double freedom = 1;            // degrees of freedom of each variance
  // The variance of a block's sum over the sum of its pixels' variances: more than 1 if a filter has
  // mixed neighbours. Known of several pictures only; else 1.
  double correlation = 1;
};

// A film with a variance in each pixel; several pictures of one size with independent samples, at least two. Both
// throw pt::Error for pictures of which the noise is not known.
NoisyPicture noisy_picture(const pt::Film& film, const std::string& name);
NoisyPicture noisy_picture(const std::vector<pt::Image>& pictures);

// The sides of the blocks in pixels; 0 is the whole picture.
inline constexpr std::array kWelchSides{4, 8, 24, 0};

// Two equal pictures are said to differ with at most this chance, all blocks together.
inline constexpr double kWelchLevel = 1e-3;

// The luminance of a in a block, less that of b.
struct BlockDifference {
  int x = 0, y = 0, width = 0, height = 0;  // from the top left
  int side = 0;                             // of kWelchSides; blocks at a border are smaller
  double off_by = 0;  // relative to the mean of b there, or to a thousandth of the whole picture's
  double p = 1;       // the chance of a difference as large, if there is none; for this block alone
  double would_be_found = 0;  // a relative difference that is found nine times of ten
};

struct WelchTest {
  std::vector<BlockDifference> blocks;  // of all sizes
  // The smallest blocks that differ, after the number of blocks of a size is taken into account; the
  // clearest first. Empty if none differs.
  std::vector<BlockDifference> differing;
};

// Throws pt::Error if the sizes differ.
WelchTest welch_test(const NoisyPicture& a, const NoisyPicture& b);

// The chance that |t| of Student's distribution is as large (Wallace 1959, Bounds on normal approximations to Student's and the
// chi-square distributions: within 1 % from 3 degrees of freedom on).
double student_p(double t, double freedom);

}  // namespace grader::pictures
