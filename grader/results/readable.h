#pragma once

#include "grader/results/results.h"

#include <string>
#include <vector>

// Failures as a person reads them. results.json has all lines and all digits.

namespace grader::results {

// Keeps six significant digits of each number, and more if rounding would turn it into a simpler
// number: 0.30000004 stays. Whole numbers stay as they are.
std::string with_few_digits(const std::string& text);

// A failure whose numbers have few digits: enough to show how far `got` is from `expected`.
struct Readable {
  Failure failure;                    // only the first ten lines of an input of more than twelve
  std::vector<std::string> left_out;  // the other lines: at most 400, and how many more
  std::size_t lines_left_out = 0;     // the number of all other lines
};
Readable readable(Failure failure);

// "and 162 more lines; --json writes them all".
std::string more_lines(std::size_t count);

}  // namespace grader::results
