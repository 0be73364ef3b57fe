#pragma once

#include "grader/pictures/goldens/golden.h"
#include "grader/results/results.h"

#include <vector>

// The averages of a picture that are compared with the golden's: every pixel, blocks of three
// sizes, and two sums over the whole picture.

namespace grader::pictures {

enum class Scale { pixel, block4, block8, block24, sum };
inline constexpr int kScales = 5;

struct Cell {
  Scale scale = Scale::pixel;
  int plane = kLuminance;
  bool weighted = false;  // the sum that favours the pixels known best
  int x = 0, y = 0, width = 0, height = 0;
};

// All cells with a pixel that is not constant. At the border of the picture, a block may be smaller.
std::vector<Cell> cells_of(const Golden& golden);

// A cell and its deviation from the golden.
struct MeasuredCell {
  Cell cell;
  double z = 0;          // distance beyond its margin, in standard deviations; at most 1e6
  double threshold = 0;  // the cell fails if |z| exceeds it
  double off_by = 0;     // relative to the golden

  double evidence() const;  // |z| / threshold
};

// Returns whether `a` is to be reported rather than `b`, two failing cells at one place: luminance is preferred, unless a channel
// is much further off.
bool says_more(const MeasuredCell& a, const MeasuredCell& b);

// Measures every cell. The thresholds are such that a right picture has a failing cell with a
// chance of at most `level`, over all cells together.
std::vector<MeasuredCell> measure(const Comparison& pictures, const std::vector<Cell>& cells,
                                  double level);

// The cells beyond their thresholds, the clearest first; at most `most`.
std::vector<MeasuredCell> exceeding(const std::vector<MeasuredCell>& measured, std::size_t most);

// The cells of `kept` that fail again on new samples, with the same sign.
std::vector<MeasuredCell> repeated(const Comparison& pictures,
                                   const std::vector<MeasuredCell>& kept, double level);

// The cells that contain no smaller failing cell, the clearest first. If several channels of a block fail,
// the one that says_more.
std::vector<MeasuredCell> smallest(std::vector<MeasuredCell> cells);

results::FailingCell failing_cell(const MeasuredCell& measured);

}  // namespace grader::pictures
