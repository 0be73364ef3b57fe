#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::report {

// The first bytes of a table: without them, some spreadsheets do not take it for UTF-8.
inline constexpr const char* kByteOrderMark = "\xef\xbb\xbf";

// A table (RFC 4180): a line that names the columns, then a line per task. Tables of many
// submissions can be joined if only one first line is kept. `complete` is false for an unfinished
// run. A text that a spreadsheet would take for a formula has an apostrophe before it.
std::string to_csv(const results::Results& results);

// A text as a field of such a table, in one line.
std::string csv_field(const std::string& text);

}  // namespace grader::report
