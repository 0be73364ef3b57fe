#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace writeup::measure {

struct Options {
  std::vector<std::string> what;  // tasks, parts, hit_sphere.half_b; empty: all
  std::map<std::string, std::string>
      own;                    // slug, or "" for all others: the folder of somebody's code
  double seconds = 0;         // by the clock, without compiling; 0: as many as it takes
  std::filesystem::path out;  // a folder; empty: no files
  std::string isolation;      // as ./run grade has it
};

// Reads the command line; prints help and exits for --help; throws pt::Error for what it cannot use. `root` is
// the project's folder: --from names a folder in it.
Options parse_options(int argc, const char* const* argv, const std::filesystem::path& root);

}  // namespace writeup::measure
