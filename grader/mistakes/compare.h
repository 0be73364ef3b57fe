#pragma once

#include "grader/mistakes/answers.h"

namespace grader::mistakes {

// Returns whether two lists of answers to one battery may come from the same mistake. Exact numbers
// have to agree to 1e-6 of the largest number of their answer. Means may differ by chance: each one
// by five standard errors at most, and all together by no more than chance exceeds once in ten
// thousand times. Two runs of the same solution disagree less than once in a thousand times.
bool agree(const Answers& a, const Answers& b);

// Returns whether an answer need not be kept, because it cannot be distinguished from the right
// one, and is not much less certain.
bool is_as_right(const Answer& answer, const Answer& right);

}  // namespace grader::mistakes
