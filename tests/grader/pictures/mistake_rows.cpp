#include "tests/grader/pictures/mistake_rows.h"

#include "grader/pictures/recipes/recipes.h"
#include "pt/error.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::tests {

namespace {

MistakeRow row_of(const std::string& line) {
  MistakeRow row;
  std::istringstream in(line);
  const auto word = [&] {
    std::string text;
    std::getline(in, text, ',');
    return text;
  };
  row.task = word();
  row.kind = word();
  row.solution = word();
  row.content = word();
  row.recipe = word();
  row.most_rounds = std::stoi(word());
  row.state = word();
  row.rounds = std::stoi(word());
  row.noise = std::stod(word());
  row.seconds = std::stod(word());
  const std::string pass = word(), ratio = word(), a = word(), b = word(), correlation = word();
  if (!pass.empty()) {
    row.map = {pass == "1", std::stod(ratio), std::stod(a), std::stod(b), std::stod(correlation)};
  }
  std::getline(in, row.text);
  return row;
}

// The row of one solution, over all recipes that judged it.
struct Seen {
  std::vector<std::string> by;    // recipes that see it
  std::vector<std::string> slow;  // in which it takes too long
  std::vector<std::string>
      at_first;  // recipes that passed it in the end, after a failing cell in the first round
};

using Solutions = std::map<std::string, Seen>;  // by name

Solutions seen(const std::vector<MistakeRow>& rows, const std::string& task,
               const std::string& kind) {
  Solutions all;
  for (const MistakeRow& row : rows) {
    if (row.task != task || row.kind != kind) continue;
    Seen& solution = all[row.solution];
    if (row.state == "timeout") solution.slow.push_back(row.recipe);
    if (row.state != "pass" && row.state != "timeout") solution.by.push_back(row.recipe);
    if (row.state == "pass" && row.rounds > 1) solution.at_first.push_back(row.recipe);
  }
  return all;
}

}  // namespace

std::string to_line(const MistakeRow& row) {
  const std::string map =
      row.map ? fmt::format("{:d},{:.3f},{:.3f},{:.3f},{:.3f}", row.map->pass, row.map->ratio,
                            row.map->a, row.map->b, row.map->correlation)
              : ",,,,";
  return fmt::format("{},{},{},{},{:.3f},{:.2f},{},{}", row.key(), row.most_rounds, row.state,
                     row.rounds, row.noise, row.seconds, map, row.text);
}

std::vector<MistakeRow> read_rows(const std::filesystem::path& path) {
  std::vector<MistakeRow> rows;
  std::ifstream file(path);
  int number = 1;
  for (std::string line; std::getline(file, line) && !file.eof();) {
    try {
      const MistakeRow row = row_of(line);
      ++number;
      const auto before = std::find_if(rows.begin(), rows.end(), [&](const MistakeRow& other) {
        return other.key() == row.key();
      });
      if (before == rows.end()) {
        rows.push_back(row);
      } else {
        *before = row;
      }
    } catch (const std::logic_error&) {
      throw pt::Error(fmt::format("{}:{}: is not a line of this benchmark; choose another --out",
                                  path.string(), number));
    }
  }
  return rows;
}

std::string table_of_mistakes(const std::vector<MistakeRow>& rows) {
  std::string table =
      "| task | wrong solutions | seen | too slow | by no picture |\n|---|---|---|---|---|\n";
  std::string others;
  std::size_t tried = 0, found = 0;
  for (const std::string& task : pictures::task_slugs()) {
    std::vector<std::string> missed, slow;
    const Solutions wrong = seen(rows, task, "wrong");
    for (const auto& [name, what] : wrong) {
      if (what.by.empty()) (what.slow.empty() ? missed : slow).push_back(name);
      if (!what.by.empty() || what.at_first.empty()) continue;
      others += fmt::format("- {}/{}: {} had a failing cell in the first round only\n", task, name,
                            fmt::join(what.at_first, ", "));
    }
    tried += wrong.size();
    const std::size_t by_pictures = wrong.size() - missed.size() - slow.size();
    found += by_pictures;
    table += fmt::format("| {} | {} | {} | {} | {} |\n", task, wrong.size(), by_pictures,
                         fmt::join(slow, ", "), fmt::join(missed, ", "));
    for (const char* kind : {"right", "noisy"}) {
      for (const auto& [name, what] : seen(rows, task, kind)) {
        if (what.by.empty() && what.at_first.empty()) continue;
        others +=
            fmt::format("- {}/{}/{}: not passed by [{}], passed after the first round by [{}]\n",
                        task, kind, name, fmt::join(what.by, ", "), fmt::join(what.at_first, ", "));
      }
    }
  }
  return table + fmt::format("| all | {} | {} | | |\n", tried, found) + "\n" + others;
}

std::string table_of_maps(const std::vector<MistakeRow>& rows, const std::string& recipe) {
  std::string table = fmt::format(
      "| {} | ratio | a (batches) | b | correlation | map | recipe "
      "|\n|---|---|---|---|---|---|---|\n",
      recipe);
  for (const MistakeRow& row : rows) {
    if (row.recipe != recipe || !row.map) continue;
    table += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {} | {} |\n",
                         row.kind == "wrong" ? row.solution : row.kind + "/" + row.solution,
                         row.map->ratio, row.map->a, row.map->b, row.map->correlation,
                         row.map->pass ? "pass" : "fail", row.state);
  }
  return table;
}

}  // namespace grader::tests
