#pragma once

#include "grader/results/results.h"

#include <cstddef>
#include <string>
#include <vector>

namespace grader::report {

struct TerminalStyle {
  bool color = false;
  bool all = false;  // every failure, not only the first
  std::size_t width = 100;
  bool input_last = false;  // below "got" and "expected", where a small window cuts the text
};

// The results for a person in front of a terminal: a table, then failures in full.
std::string to_text(const results::Results& results, const TerminalStyle& style);

// The parts of this text: a row for each task and for each of its wrong pictures, and a text about
// each failure, in the order of the report.
std::string table(const results::Results& results, const TerminalStyle& style);
struct FailureText {
  std::string slug;
  std::string promise;  // the property; empty: a picture, or the whole task
  std::string text;
};
std::vector<FailureText> failure_texts(const results::TaskResult& task, const TerminalStyle& style);

// Returns whether standard output is a terminal that shows colours and NO_COLOR is not set.
bool terminal_has_color();

}  // namespace grader::report
