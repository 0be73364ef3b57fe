#pragma once

#include <string>
#include <vector>

namespace writeup {

// The options that an author gives; main.cpp says where the rest comes from.
struct Options {
  std::vector<std::string> what;  // parts and figures; empty: all
  bool list = false, draft = false, pdf = false, retry = false;
  bool handbook = false, check = false;
  std::string scenes, submission, out, texts;
  std::string from = "reference";  // a mixture, as ./run has it
  int threads = 1;
  // Set by ./run.
  std::string renderer, accuracy, stability, measure, generate, mistakes, work, boxed;
};

// Throws CommandLine for --help and for what it cannot use, with the exit status.
struct CommandLine {
  int status = 0;
};
Options parse_options(int argc, const char* const* argv);

}  // namespace writeup
