#pragma once

#include "pt/end_of_program.h"

#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>

namespace pt {

// The exit status for main: that of `run` once the arguments fit the app's options, 0 where they
// ask for help, and 2 after one sentence where they do not fit or run throws.
template <class Run>
int run_command_line(CLI::App& app, int argc, const char* const* argv, Run run) {
  try {
    app.parse(argc, argv);
    const int status = run();
    flush_standard_output();
    return status;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", sentence_of(error).c_str());
    return 2;
  }
}

}  // namespace pt
