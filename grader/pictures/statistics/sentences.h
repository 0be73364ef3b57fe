#pragma once

#include "grader/pictures/statistics/cells.h"
#include "grader/pictures/statistics/guards.h"

#include <string>
#include <vector>

// The sentence about a picture that failed: where to look, how far off it is, and in which direction.

namespace grader::pictures {

// "this block (8x8 at 32, 40) was 9.4 % too dark in three independent renders". One sentence for
// all failing cells: about the whole picture if it is off as much as any part of it. No list may
// be empty.
std::string sentence(const std::vector<MeasuredCell>& all,
                     const std::vector<MeasuredCell>& smallest, int renders);

std::string sentence(const std::vector<WrongConstant>& constants, const Golden& golden,
                     int renders);
std::string correlated_sentence(int renders);
std::string too_near_sentence(int renders);
std::string too_noisy_sentence(double ratio);
std::string noisy_and_wrong_sentence(double ratio, double energy_off, int renders);

}  // namespace grader::pictures
