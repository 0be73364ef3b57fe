#pragma once

#include "grader/pictures/cells.h"
#include "grader/pictures/guards.h"

#include <string>
#include <vector>

// What a person reads of a picture that failed: what to look at, how far off it is, which way.

namespace grader::pictures {

// "this block (8x8 at 32, 40) was 9.4 % too dark in three independent renders". One sentence for
// all complaints: about the whole picture if it is off as much as any part of it. None may be
// empty.
std::string sentence(const std::vector<Complaint>& all, const std::vector<Complaint>& smallest,
                     int renders);

std::string sentence(const std::vector<WrongConstant>& constants, const Golden& golden,
                     int renders);
std::string correlated_sentence(int renders);
std::string too_noisy_sentence(double ratio);
std::string noisy_and_wrong_sentence(double ratio, double energy_off, int renders);

}  // namespace grader::pictures
