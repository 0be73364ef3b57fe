#pragma once

#include "grader/results/results.h"

#include <string>
#include <vector>

// Failures as a person reads them. results.json has all lines and all digits.

namespace grader::results {

// Six significant digits of each number, more where the number is so close to a simpler one that it
// would become that one: 0.30000004 stays. Whole numbers stay as they are.
std::string with_few_digits(const std::string& text);

// The failure with the first ten lines of an input of more than twelve, and numbers with few
// digits: as many as show how far `got` is from `expected`.
Failure readable(Failure failure);

// The lines of its input that readable() leaves out, with few digits; of thousands the first ones.
std::vector<std::string> left_out(const Failure& failure);

}  // namespace grader::results
