// graded.<slug>: the properties of one task, whose calls go to a worker. Trusted: no line of a
// submission runs in here. Writes its findings as a results.json; the exit status is 0 if every
// promise held, 1 if one did not, 2 if nothing could be judged. With --battery it runs the task's
// battery instead (grader/mistakes/battery.h), and writes the answers.
#include "grader/check/language/property.h"
#include "grader/mistakes/battery.h"
#include "grader/programs/write_report.h"
#include "grader/service/wire/ask_worker.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cstdlib>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace {

struct Options {
  grader::wire::AskOptions ask;
  std::string report;
  std::string promises = "*";  // a filter of GoogleTest
  std::string battery;         // the file for the answers
  int draws = 1;               // times the usual number
};

// Calls of a battery take a few milliseconds. A call that takes this long hangs, even on a busy
// machine.
constexpr std::chrono::milliseconds kBatteryCallLimit{2000};

// Right solutions send at most a ninth of this (trace_path, 29 MB), in their properties or in a battery.
constexpr std::uint64_t kMaxAnswered = std::uint64_t{256} << 20;

int run_battery(const Options& options) {
  grader::wire::SessionSettings session = options.ask.session;
  session.call_limit = kBatteryCallLimit;
  session.total_limit = std::chrono::minutes(1);
  session.max_answered = kMaxAnswered * static_cast<std::uint64_t>(options.draws);
  session.give_up = [](grader::results::Cause cause, const std::string&) {
    throw grader::mistakes::CallEnded{cause};
  };
  grader::wire::open_session(session);
  grader::mistakes::Battery battery({options.ask.seed, options.draws});
  grader::mistakes::run_battery(battery);
  pt::write_file(options.battery, grader::mistakes::to_json(battery.answers()) + "\n");
  return 0;
}

int run(const Options& options, const char* program) {
  grader::wire::SessionSettings session = options.ask.session;
  session.max_answered = kMaxAnswered;
  setenv("FIRSTLIGHT_SEED", std::to_string(options.ask.seed).c_str(), 1);
  grader::wire::open_session(session);
  std::string filter = "--gtest_filter=" + options.promises;
  std::string name = program, brief = "--gtest_brief=1";
  char* arguments[] = {name.data(), filter.data(), brief.data(), nullptr};
  int count = 3;
  testing::InitGoogleTest(&count, arguments);
  const int failed = RUN_ALL_TESTS();
  const auto& test = *testing::UnitTest::GetInstance();
  if (!options.report.empty()) {
    grader::programs::write_report(options.report, test, session, grader::wire::session().record());
  }
  if (test.test_to_run_count() == 0) throw pt::Error("no property was run: nothing is judged");
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Checks the properties of one task on a worker"};
  // The linked properties are a suite with the name of the task.
  options.ask.session.task = testing::UnitTest::GetInstance()->GetTestSuite(0)->name();
  app.add_option("--report", options.report, "where to write the findings, as JSON");
  app.add_option("--promises", options.promises, "only these promises: names as in --gtest_filter");
  app.add_flag_callback("--no-shrinking", grader::check::never_shrink,
                        "keep the first input that fails");
  app.add_option("--battery", options.battery,
                 "run the battery instead: where to write the answers");
  app.add_option("--draws", options.draws, "draws of the battery: times the usual number")
      ->check(CLI::PositiveNumber);
  return grader::wire::run_asking(app, argc, argv, options.ask, [&] {
    return options.battery.empty() ? run(options, argv[0]) : run_battery(options);
  });
}
