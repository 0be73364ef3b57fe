#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grader::report {

struct CsvCell {
  std::string value;
  std::size_t at = 0, size = 0;  // its place in the text, with its quotation marks
};

struct CsvRow {
  int line = 0;  // where it begins, from 1 on
  std::vector<CsvCell> cells;
};

struct CsvTable {
  char separator = ',';
  std::vector<CsvRow> rows;
};

// Reads a table (RFC 4180) with any line ends, an optional byte order mark, and commas, semicolons
// or tabs. Empty lines are left out. Throws pt::Error, with the line, if it is not UTF-8, or if a
// quotation is not closed or has text after its closing mark. `path` is for that message.
CsvTable read_csv(std::string_view text, const std::string& path);

}  // namespace grader::report
