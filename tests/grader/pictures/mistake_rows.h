#pragma once

#include "tests/grader/pictures/map_figures.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The results of the benchmark verdict_mistakes: the pictures that see each mistake.

namespace grader::tests {

// One solution of one task, judged by one recipe.
struct MistakeRow {
  std::string task;      // slug
  std::string kind;      // its folder: "wrong", "right" or "noisy"
  std::string solution;  // the file's name, without .cpp
  std::string content;   // the beginning of the file's hash: a changed file is judged again
  std::string recipe;
  int most_rounds = 0;  // limit of the rounds
  std::string state;    // of the picture: "pass", "fail", "too_noisy" ...
  int rounds = 0;  // more than one if the first round found a failing cell; 0 without a picture
  double noise = 0;
  double seconds = 0;
  std::optional<MapFigures> map;  // only for an adaptive recipe
  std::string text;

  // Returns a key that is unique to the row.
  std::string key() const {
    return task + ',' + kind + ',' + solution + ',' + content + ',' + recipe;
  }
};

// Returns a line without its end: the members in order; those of a missing map are empty.
std::string to_line(const MistakeRow& row);

// Returns the rows of all complete lines, the last one for each key. Returns nothing if there is no
// file. Throws pt::Error for any other line.
std::vector<MistakeRow> read_rows(const std::filesystem::path& path);

// Returns Markdown. For each task: the number of solutions tried, the number that a picture sees,
// and the solutions that no picture sees; then the solutions of right/ and noisy/ that did not pass
// everywhere.
std::string table_of_mistakes(const std::vector<MistakeRow>& rows);

// Returns Markdown with a line for each sample map of a recipe.
std::string table_of_maps(const std::vector<MistakeRow>& rows, const std::string& recipe);

}  // namespace grader::tests
