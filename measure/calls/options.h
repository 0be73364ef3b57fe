#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace measure::calls {

// Somebody's own code, which may be wrong.
struct Own {
  std::string slug;    // empty: every task that has no code of its own here
  std::string folder;  // or the object of a mistake
  std::string name;    // in tables and charts
};

struct Options {
  std::vector<std::string> what;  // tasks, parts, hit_sphere.half_b; empty: all
  std::vector<Own> own;
  double seconds = 0;                    // by the clock, without compiling; 0: as long as needed
  std::filesystem::path out;             // a folder; empty: no files
  std::vector<std::string> submissions;  // folders, archives or clones of the course
  std::string isolation;                 // as ./run grade has it
};

// Reads the command line. Prints help and exits for --help; throws pt::Error for unusable options.
// `root` is the project's folder: --from names a folder in it.
Options parse_options(int argc, const char* const* argv, const std::filesystem::path& root);

}  // namespace measure::calls
