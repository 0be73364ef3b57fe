#pragma once

#include "grader/results/results.h"

#include <string>

// Some texts of a report come from a submission: its output, its exceptions, the names of its
// files.

namespace grader::results {

inline constexpr std::size_t kMaxText = 8192;  // bytes
inline constexpr std::size_t kMaxList = 100;   // failures of a promise, lines of an input, cells

// Valid UTF-8 that every format can hold and no reader is misled by: bytes that are not UTF-8,
// control characters but for newline and tab, and the characters that turn the direction of writing
// become U+FFFD; of a text longer than kMaxText the beginning, and how much is missing.
std::string presentable(const std::string& text);

// The same without newlines and tabs: for names, which stand in the middle of lines.
std::string one_line(const std::string& text);

// All texts presentable, names in one line, no list longer than kMaxList. Doing it twice changes nothing more.
Results presentable(Results results);

}  // namespace grader::results
