#pragma once

#include "pt/image/image.h"

#include <array>
#include <vector>

// One picture is compared with pictures of the same settings by the reference. There is only the one, so a suspicion cannot be tested
// on new samples: the thresholds are far out, and our own pictures say how far a right one lies.

namespace grader::pictures {

// The sides of the blocks whose luminance is compared; 0 is the whole picture.
inline constexpr std::array kSingleSides{8, 24, 0};

// A right picture is called wrong with at most this chance, by the tests of all sides together.
inline constexpr double kSingleLevel = 1e-3;

// A right picture may have so much more variance than ours: another sampler, another choice of directions.
inline constexpr double kMostNoise = 3;

struct SingleBlock {
  int x = 0, y = 0, width = 0, height = 0;  // from the top left
  int side = 0;
  double off_by = 0;    // relative to ours
  double evidence = 0;  // |difference| beyond its margin, over the threshold: more than 1 is wrong
  double would_be_found = 0;  // the relative difference at the threshold
};

struct Agreement {
  double noise = 0;  // variance between neighbours, over that of our pictures
  double distance =
      0;  // the sum of the squares of all differences of 8 x 8 pixels, in standard deviations
  std::vector<SingleBlock> blocks;
  SingleBlock worst;  // the one with most evidence
  bool agrees() const { return worst.evidence <= 1; }
  bool is_too_noisy() const { return noise > kMostNoise; }
};

// The change that the codec makes to the mean of our pictures.
struct CodecMeans {
  pt::Image quiet;            // the mean of the pictures before the codec, through it
  pt::Image soft;             // the same of a mean over 3 x 3 pixels, as a wide filter makes it
  std::vector<double> steps;  // the width of a code, in luminance; empty for floats
};

// Our own pictures, with mean and variance of one of them, of the luminance of each pixel.
struct OwnPictures {
  int width = 0, height = 0;
  std::vector<pt::Image> pictures;  // at least 8, independent, through the codec of the judged one
  pt::Image mean;
  std::vector<double> variance;  // half a pixel's own, half its neighbours': few pictures show it
  std::vector<double> step;      // the width of a code, in luminance; empty for floats
  // The part of the noise that clipping takes: the mean of all, through the codec, less `mean`. And the part of that that a wide filter takes.
  std::vector<double> clipped, filtered;
  double noise = 1;  // of ours, by the measure of Agreement::noise
  double taken = 1;  // the samples of one of ours over those of the judged picture, at most 1
};

OwnPictures own_pictures(std::vector<pt::Image> pictures, const CodecMeans& means,
                         double taken = 1);

// The mean over 3 x 3 pixels, inside the picture.
pt::Image softened(const pt::Image& image);

pt::Image mean_of(const std::vector<pt::Image>& pictures);

// The sizes are equal.
Agreement compare(const pt::Image& picture, const OwnPictures& own);

}  // namespace grader::pictures
