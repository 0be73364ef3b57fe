#pragma once

#include "grader/report/results.h"

#include <string>

namespace grader {

struct TerminalStyle {
  bool color = false;
  bool all = false;  // every failure, not only the first
};

// The results for a person in front of a terminal: a table, then failures in full.
std::string to_text(const Results& results, const TerminalStyle& style);

// Whether standard output is a terminal that shows colours and NO_COLOR is not set.
bool terminal_has_color();

}  // namespace grader
