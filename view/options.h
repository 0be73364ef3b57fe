#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace view {

// The options of ./run view.
struct Options {
  std::filesystem::path scene;  // or the name of a picture by which the grader judges
  bool lambertian = false;
  std::map<std::string, std::string> settings;  // as the page sends them
  std::optional<std::pair<int, int>> pixel;     // from the bottom left, as the tasks count
  int port = 0;
  bool no_browser = false;
  std::filesystem::path page;  // to write; empty: serve
  // Given by ./run:
  std::filesystem::path worker, reference;
  std::filesystem::path
      boxed;  // in place of a worker: a submission's, as writeup_boxed describes it
  std::filesystem::path tasks;     // the files of the tasks
  std::vector<std::string> build;  // scripts/ninja.sh, and the folder where it compiles them
  std::string from = "reference";
};

// Throws pt::Error if the words cannot be used. Prints help and exits for --help.
Options parse_options(int argc, const char* const* argv);

}  // namespace view
