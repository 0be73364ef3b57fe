#include "grader/mistakes/solutions.h"

#include "pt/error.h"
#include "pt/file.h"

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

}  // namespace grader::mistakes
