#include "grader/mistakes/solutions.h"

#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <set>
#include <sstream>

namespace grader::mistakes {

std::vector<Solution> read_solutions(const std::string& path) {
  std::vector<Solution> all;
  std::istringstream lines(pt::read_file(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Solution solution;
    if (!(words >> solution.name >> solution.breaks)) {
      throw pt::Error(path + ":" + std::to_string(all.size() + 1) +
                      ": a line has a name and a promise; build the target graded again");
    }
    if (solution.breaks == "right") solution.breaks.clear();
    all.push_back(std::move(solution));
  }
  return all;
}

void mark_ordinary(std::vector<Solution>& solutions, const std::string& path) {
  if (!std::filesystem::exists(path)) return;
  std::set<std::string> ordinary;
  std::istringstream names(pt::read_file(path));
  for (std::string name; names >> name;) ordinary.insert(name);
  for (Solution& solution : solutions) solution.is_ordinary = ordinary.contains(solution.name);
}

}  // namespace grader::mistakes
