#pragma once

#include <string>

namespace grader::watch {

struct ScreenSize {
  int columns = 80, rows = 24;
};

// The size of the terminal on standard output.
ScreenSize screen_size();

// Makes a text fit on a screen. Long lines are broken between words; the rest of a line with a label goes below its
// value. If there are too many rows, the first ones are kept, and the last row says how many are missing.
std::string fit(const std::string& text, const ScreenSize& screen);

}  // namespace grader::watch
