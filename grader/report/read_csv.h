#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grader::report {

struct CsvCell {
  std::string value;
  std::size_t at = 0, size = 0;  // where it stands in the text, with its quotation marks
};

struct CsvRow {
  int line = 0;  // on which it begins, from 1 on
  std::vector<CsvCell> cells;
};

struct CsvTable {
  char separator = ',';
  std::vector<CsvRow> rows;
};

// Reads a table (RFC 4180) as others write it: with any line ends, perhaps a byte order mark, and a semicolon or a tab in
// place of the comma. Empty lines are left out. Throws pt::Error, with the line, if it is not UTF-8, or a quotation is not
// closed or goes on behind its mark;
// `path` is for that sentence.
CsvTable read_csv(std::string_view text, const std::string& path);

}  // namespace grader::report
