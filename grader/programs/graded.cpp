// graded.<slug>: the properties of one task, whose calls go to a worker. Trusted: no line of a
// submission runs in here. Writes what it found as a results.json; the exit status is 0 if every
// promise held, 1 if one did not, 2 if nothing could be judged. With --battery it runs the task's
// battery instead (grader/mistakes/battery.h), and writes the answers; with --curves it measures where
// the task's methods fail (grader/check/curve.h); with --search it looks for bad inputs
// (grader/check/bad_inputs.h).
#include "grader/check/bad_inputs.h"
#include "grader/check/property.h"
#include "grader/mistakes/battery.h"
#include "grader/process/spawn.h"
#include "grader/programs/graded_curves.h"
#include "grader/programs/graded_report.h"
#include "grader/wire/session.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace {

struct Options {
  grader::wire::SessionSettings session;
  std::string report;
  std::string promises = "*";  // a filter as GoogleTest has it
  std::uint64_t seed = 1;
  std::string battery;  // the file for the answers
  int draws = 1;        // times the usual number
  std::string curves;   // the file for them
  std::string curve;    // only this one
  double effort = 1;    // times the usual number of cases
  bool coarse = false;  // every third place
  std::string search;   // the file for the worst inputs
  double seconds = 60;  // of the search
};

// All calls of a battery take some milliseconds: one that takes this long hangs, also on a busy
// machine.
constexpr std::chrono::milliseconds kBatteryCallLimit{2000};

// Right solutions send a ninth of it at most (trace_path, 29 MB), in their properties or in a battery.
constexpr std::uint64_t kMaxAnswered = std::uint64_t{256} << 20;

// Properties take an exception for a case that failed.
[[noreturn]] void end_at_fault(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::exit(2);
}

int run_battery(Options options) {
  options.session.call_limit = kBatteryCallLimit;
  options.session.total_limit = std::chrono::minutes(1);
  options.session.max_answered = kMaxAnswered * static_cast<std::uint64_t>(options.draws);
  options.session.give_up = [](grader::results::Cause cause, const std::string&) {
    throw grader::mistakes::CallEnded{cause};
  };
  grader::wire::open_session(options.session);
  grader::mistakes::Battery battery({options.seed, options.draws});
  grader::mistakes::run_battery(battery);
  pt::write_file(options.battery, grader::mistakes::to_json(battery.answers()) + "\n");
  return 0;
}

// One call that hangs says enough about a place.
int run_curves(Options options) {
  options.session.max_timeouts = 1;
  options.session.total_limit = std::chrono::minutes(5);
  grader::programs::write_curves(options.curves, options.curve,
                                 {options.seed, options.effort, options.coarse},
                                 [&] { grader::wire::open_session(options.session); });
  return 0;
}

int run_search(Options options) {
  options.session.max_timeouts = 1;
  options.session.total_limit = std::chrono::hours(1);
  options.session.max_failures = 1000000000;
  grader::check::run_searches({options.seed, options.seconds, options.search,
                               [&] { grader::wire::open_session(options.session); }});
  return 0;
}

int run(Options options, const char* program) {
  options.session.max_answered = kMaxAnswered;
  setenv("FIRSTLIGHT_SEED", std::to_string(options.seed).c_str(), 1);
  grader::wire::open_session(options.session);
  std::string filter = "--gtest_filter=" + options.promises;
  std::string name = program, brief = "--gtest_brief=1";
  char* arguments[] = {name.data(), filter.data(), brief.data(), nullptr};
  int count = 3;
  testing::InitGoogleTest(&count, arguments);
  const int failed = RUN_ALL_TESTS();
  const auto& test = *testing::UnitTest::GetInstance();
  if (!options.report.empty()) {
    grader::programs::write_report(options.report, test, options.session,
                                   grader::wire::session().record());
  }
  if (test.test_to_run_count() == 0) throw pt::Error("no property was run: nothing is judged");
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  Options options;
  CLI::App app{"Checks the properties of one task on a worker"};
  int call_limit = static_cast<int>(grader::process::kCallLimit.count());
  std::string tier = "C";
  app.add_option("--worker", options.session.program, "the worker program")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--report", options.report, "where to write the findings, as JSON");
  app.add_option("--promises", options.promises, "only these: names as in --gtest_filter");
  app.add_flag_callback("--no-shrinking", grader::check::never_shrink,
                        "keep the first input that fails");
  app.add_option("--seed", options.seed, "of all random inputs");
  app.add_option("--battery", options.battery,
                 "run the battery instead: where to write the answers");
  app.add_option("--draws", options.draws, "of the battery: times the usual number")
      ->check(CLI::PositiveNumber);
  app.add_option("--curves", options.curves,
                 "measure where the task's methods fail instead: where to write the curves");
  app.add_option("--curve", options.curve, "only the curve of this name");
  app.add_option("--effort", options.effort, "of the curves: times the usual number of cases")
      ->check(CLI::PositiveNumber);
  app.add_option("--search", options.search,
                 "search for bad inputs instead: where to keep the worst");
  app.add_option("--seconds", options.seconds, "of the search")->check(CLI::PositiveNumber);
  app.add_flag("--coarse", options.coarse, "of the curves: every third place only");
  app.add_flag("--integrated", options.session.integrated, "the worker runs all tasks");
  app.add_option("--call-limit", call_limit, "milliseconds that one call may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--isolation", tier, "the tier of the worker's box: A, B or C");
  options.session.at_fault = end_at_fault;
  // The suite of the properties that are linked.
  options.session.task = testing::UnitTest::GetInstance()->GetTestSuite(0)->name();
  return pt::run_command_line(app, argc, argv, [&] {
    options.session.program = std::filesystem::absolute(options.session.program);
    options.session.tier = grader::sandbox::tier_of(tier);
    options.session.call_limit = std::chrono::milliseconds(call_limit);
    options.session.total_limit = 15 * options.session.call_limit;
    if (!options.curves.empty()) return run_curves(options);
    if (!options.search.empty()) return run_search(options);
    return options.battery.empty() ? run(options, argv[0]) : run_battery(options);
  });
}
