#pragma once

#include <string>

namespace grader::programs {

struct ScreenSize {
  int columns = 80, rows = 24;
};

// The size of the terminal that standard output is.
ScreenSize screen_size();

// A text as a screen shows it whole: longer lines are broken between words,
// the rest of a line with a label below its value; and the first rows, with a word about the others.
std::string fit(const std::string& text, const ScreenSize& screen);

}  // namespace grader::programs
