#pragma once

#include "grader/mistakes/answers.h"

namespace grader::mistakes {

// Returns whether two lists of answers to one battery may come from the same mistake. Numbers that
// are exact agree to 1e-6 of the largest number of their answer. Means may differ by chance: none
// by more than five standard errors, nor all together by more than they do once in ten thousand
// times. Two runs of the same solution are told apart less than once in a thousand times.
bool agree(const Answers& a, const Answers& b);

// Returns whether an answer need not be kept, because it is as the right one as far as it tells.
bool is_as_right(const Answer& answer, const Answer& right);

}  // namespace grader::mistakes
