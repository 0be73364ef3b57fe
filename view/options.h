#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

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
  std::filesystem::path tasks,
      build;  // the files of the tasks, and the folder where ninja compiles them
  std::string from = "reference";
};

// Throws pt::Error if the words cannot be used. Prints help and exits for --help.
Options parse_options(int argc, const char* const* argv);

}  // namespace view
