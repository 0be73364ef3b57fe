#pragma once

#include <string>
#include <vector>

namespace writeup {

// The options of an author, and those that ./run adds.
struct Options {
  std::vector<std::string> what;  // parts and figures; empty: all
  bool list = false, draft = false, pdf = false, retry = false;
  bool handbook = false, check = false;
  std::string scenes, out, texts;
  // One: the pages are about it. Several: they are about the reference, with the pictures of each beside it.
  std::vector<std::string> submissions;
  std::string from = "reference";  // a mixture, as in ./run
  int threads = 1;
  // Set by ./run.
  std::string root = ".";  // of the project: the catalogues are in its folder writeup/
  std::string renderer, accuracy, stability, measure, view, view_worker, generate, mistakes, work,
      boxed, by;
};

// Returns whether the pages are about a submission alone.
inline bool is_of_submission(const Options& options) { return options.submissions.size() == 1; }

// Prints help and exits for --help; throws pt::Error for what it cannot use.
Options parse_options(int argc, const char* const* argv);

}  // namespace writeup
