#pragma once

#include "pt/end_of_program.h"
#include "pt/error.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

namespace pt {

// Prints the help that was asked for, or why a command line does not fit. Returns main's exit status, 0 or 2. Throws
// Error if the help did not arrive.
inline int exit_status(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    app.exit(error);
    flush_standard_output();
    return 0;
  }
  // It names files as they were typed: a shell's wildcard may have found them.
  std::fprintf(stderr, "%s\nRun with --help for more information.\n", sentence_of(error).c_str());
  return 2;
}

// Fills the app's options. Help that is asked for is printed and ends the program. Throws Error where the arguments
// do not fit.
inline void parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    std::exit(exit_status(app, help));
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + "; see " + app.get_name() + " --help");
  }
}

// The exit status for main: that of `run` once the arguments fit the app's options, 0 where they
// ask for help, and 2 after one sentence where they do not fit or run throws.
template <class Run>
int run_command_line(CLI::App& app, int argc, const char* const* argv, Run run) try {
  try {
    app.parse(argc, argv);
    const int status = run();
    flush_standard_output();
    return status;
  } catch (const CLI::ParseError& error) {
    return exit_status(app, error);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", sentence_of(error).c_str());
  return 2;
}

}  // namespace pt
