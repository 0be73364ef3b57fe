#pragma once

#include "grader/results/results.h"

#include <string>

// Some texts of a report come from a submission: its output, its exceptions, the names of its
// files.

namespace grader::results {

inline constexpr std::size_t kMaxText = 8192;  // bytes
inline constexpr std::size_t kMaxList = 100;   // failures of a promise, lines of an input, cells

// Returns valid UTF-8 that every format can contain and that misleads no reader: bytes that are not
// UTF-8, control characters except newline and tab, and characters that change the direction of
// writing become U+FFFD. A longer text than kMaxText is cut, and says how much is missing.
[[nodiscard]] std::string presentable(const std::string& text);

// The same without newlines and tabs, for names in the middle of lines.
[[nodiscard]] std::string one_line(const std::string& text);

// Makes all texts presentable, each name one line, and no list longer than kMaxList. A second call changes nothing.
[[nodiscard]] Results presentable(Results results);

}  // namespace grader::results
