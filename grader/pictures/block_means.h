#pragma once

#include "pt/image/film.h"
#include "pt/image/sample_map.h"

#include <string>
#include <vector>

// A picture as means over blocks of 8 x 8 pixels: little enough to be kept for every mistake that
// is known, and so little noise that one mistake is told from another.

namespace grader::pictures {

struct BlockMean {
  double mean = 0;
  double error = 0;  // its standard deviation

  bool operator==(const BlockMean&) const = default;
};

struct BlockMeans {
  int samples = 0;  // per pixel; of an adaptive picture, runs
  // Red, green and blue, and of an adaptive picture the samples that its pixels took; in each the
  // blocks row by row, the top row first. The part of a block that a ragged border leaves is a
  // block too.
  std::vector<std::vector<BlockMean>> planes;

  bool operator==(const BlockMeans&) const = default;
};

// Precondition: the film knows its samples and variances.
BlockMeans block_means(const pt::Film& film);

// Adds the plane of the samples per pixel, of one run. Their variation between runs is not known;
// it is taken from the variation within a block, which is larger.
void add_counts(BlockMeans& blocks, const pt::SampleMap& counts);

// In letters and digits, means to 0.01 % and errors to 1 %; 5 characters for each value.
std::string to_text(const BlockMeans& blocks);

// Throws pt::Error for anything that to_text does not write.
BlockMeans block_means_from(const std::string& text);

// Returns whether both pictures may come from one program, within their noise. A picture of the
// program that made `known` is rejected less than once in a thousand times. Returns false for
// pictures of different shapes.
bool can_be(const BlockMeans& picture, const BlockMeans& known);

}  // namespace grader::pictures
