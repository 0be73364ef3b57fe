#pragma once

#include "grader/self_check/map_figures.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The results of the benchmark verdict_mistakes: the pictures that see each mistake.

namespace grader::self_check {

// One solution of one task, judged by one recipe.
struct MistakeRow {
  std::string task;      // slug
  std::string kind;      // the folder it is in: "wrong", "right", "noisy"
  std::string solution;  // the file's name, without .cpp
  std::string content;   // the beginning of its hash: a file that has changed is judged again
  std::string recipe;
  int most_rounds = 0;  // that it was given
  std::string state;    // of the picture: "pass", "fail", "too_noisy" ...
  int rounds =
      0;  // more than one where the first found a failing cell; 0 where there was no picture
  double noise = 0;
  double seconds = 0;
  std::optional<MapFigures> map;  // of an adaptive recipe
  std::string text;

  // Unique to it.
  std::string key() const {
    return task + ',' + kind + ',' + solution + ',' + content + ',' + recipe;
  }
};

// A line without its end: the members in their order, those of the map empty where there is none.
std::string to_line(const MistakeRow& row);

// Those of every line that ends, of several with one key the last; none if there is no file. Throws
// pt::Error for other lines.
std::vector<MistakeRow> read_rows(const std::filesystem::path& path);

// Markdown. Of each task: the number of solutions that were tried, the number that a picture sees,
// and the solutions that none does; and the solutions in right/ and noisy/ that did not pass
// everywhere.
std::string table_of_mistakes(const std::vector<MistakeRow>& rows);

// Markdown. A line for each sample map of a recipe.
std::string table_of_maps(const std::vector<MistakeRow>& rows, const std::string& recipe);

}  // namespace grader::self_check
