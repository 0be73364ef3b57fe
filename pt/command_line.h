#pragma once

#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/number.h"

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>

namespace pt {

// For options that are a number above 0: NaN, infinity and numbers too large for a double are none.
inline std::string check_above_zero(const std::string& word) {
  const auto value = number_in<double>(word);
  return value && *value > 0 && *value <= std::numeric_limits<double>::max()
             ? ""
             : "'" + word + "' is not a number above 0, as 1.5 is";
}

// For seeds.
inline std::string check_seed(const std::string& word) {
  return number_in<std::uint64_t>(word) ? ""
                                        : "'" + word + "' is not an integer from 0 to 2^64 - 1";
}

// Fills the app's options from main's arguments, or from words in reverse, as CLI11 takes them. Help that is asked for
// is printed and ends the program. Throws Error where the words do not fit, or the help did not arrive.
template <class... Arguments>
void parse(CLI::App& app, Arguments... arguments) {
  try {
    app.parse(arguments...);
  } catch (const CLI::Success& help) {
    app.exit(help);
    flush_standard_output();
    std::exit(0);
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + "; see " + app.get_name() + " --help");
  }
}

// The exit status for main: that of `run` once the arguments fit the app's options, 0 where they
// ask for help, and 2 after one sentence where they do not fit or run throws.
template <class Run>
int run_command_line(CLI::App& app, int argc, const char* const* argv, Run run) {
  return run_program([&] {
    parse(app, argc, argv);
    return run();
  });
}

}  // namespace pt
