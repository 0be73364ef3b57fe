#include "grader/service/wire/ask_worker.h"

#include "grader/service/process/spawn.h"
#include "pt/command_line.h"
#include "pt/printable.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

namespace grader::wire {

namespace {

// This must not be an exception: properties would count it as a failed case.
[[noreturn]] void end_at_fault(const std::string& why) {
  std::fprintf(stderr, "%s\n", pt::printable(why).c_str());
  std::exit(2);
}

}  // namespace

int run_asking(CLI::App& app, int argc, char** argv, AskOptions& ask,
               const std::function<int()>& run) {
  process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  int call_limit = static_cast<int>(process::kCallLimit.count());
  std::string tier = "C";
  app.add_option("--worker", ask.session.program, "the worker program")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--isolation", tier, "the tier of the worker's box: A, B or C");
  app.add_option("--call-limit", call_limit, "milliseconds that one call may take")
      ->check(CLI::PositiveNumber);
  app.add_flag("--integrated", ask.session.integrated, "the worker runs all tasks");
  app.add_option("--seed", ask.seed, "the seed of all random inputs");
  return pt::run_command_line(app, argc, argv, [&] {
    ask.session.program = std::filesystem::absolute(ask.session.program);
    ask.session.tier = sandbox::tier_of(tier);
    ask.session.call_limit = std::chrono::milliseconds(call_limit);
    ask.session.total_limit = limit_of_all_calls(ask.session.call_limit);
    ask.session.at_fault = end_at_fault;
    return run();
  });
}

}  // namespace grader::wire
