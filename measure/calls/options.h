#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace measure::calls {

struct Options {
  std::vector<std::string> what;           // tasks, parts, hit_sphere.half_b; empty: all
  std::map<std::string, std::string> own;  // a folder of code by slug, or by "" for all other tasks
  double seconds = 0;                      // by the clock, without compiling; 0: as long as needed
  std::filesystem::path out;               // a folder; empty: no files
  std::string submission;  // a folder, an archive or a clone of the course, for all other tasks
  std::string isolation;   // as ./run grade has it
};

// Reads the command line. Prints help and exits for --help; throws pt::Error for unusable options.
// `root` is the project's folder: --from names a folder in it.
Options parse_options(int argc, const char* const* argv, const std::filesystem::path& root);

}  // namespace measure::calls
