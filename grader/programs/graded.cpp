// graded.<slug>: the properties of one task, whose calls go to a worker. Trusted: no line of a
// submission runs in here. Writes its findings as a results.json; the exit status is 0 if every
// promise held, 1 if one did not, 2 if nothing could be judged. With --battery it runs the task's
// battery instead (grader/mistakes/battery.h), and writes the answers.
#include "grader/base/printable.h"
#include "grader/check/generators/precision.h"
#include "grader/check/language/property.h"
#include "grader/check/wild/search.h"
#include "grader/mistakes/battery.h"
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "grader/service/audit/object_file.h"
#include "grader/service/wire/ask_worker.h"
#include "grader/service/wire/kept_state.h"
#include "grader/service/wire/session.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <cxxabi.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace grader::programs {

namespace {

results::PromiseResult describe(const testing::TestInfo& promise, bool integrated) {
  results::PromiseResult result;
  result.name = promise.name();
  result.bonus = result.name.ends_with("_bonus");
  result.held = promise.result()->Passed();
  result.seconds = static_cast<double>(promise.result()->elapsed_time()) * 1e-3;
  result.checks = check::checks_of(result.name);
  for (const check::FailedPromise& failed : check::failures()) {
    if (failed.promise != result.name) continue;
    result.failures.push_back(failed.failure);
    result.failures.back().integrated = integrated;
  }
  return result;
}

// Returns count for "pt::(anonymous namespace)::count" and "pt::hit_bvh(...)::count"; "" if not known.
std::string variable_at(const std::string& worker, std::uint64_t place) {
  const std::string symbol = audit::state_at(pt::read_file(worker), place);
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  const std::string name = text ? text.get() : symbol;
  const std::size_t last = name.rfind("::");
  return base::printable(last == name.npos ? name : name.substr(last + 2), 100);
}

std::string kept_reason(const std::string& worker, std::uint64_t kept) {
  if (kept == wire::kProcessorMode) {
    return "a call changes how the processor rounds or what it does with tiny numbers, and the "
           "next "
           "call is computed like that: change it back before you return, or leave it as it is";
  }
  if (kept == wire::kOtherAnswer) {
    return "one of its first calls has another answer when it is made again at the end: it keeps "
           "something from one call to the next, and an answer may depend on the arguments alone";
  }
  const std::string name = variable_at(worker, kept - 1);
  return fmt::format(
      "it keeps {} between calls, and tasks are called from several threads at once: "
      "make it a local variable, a constant, or thread_local",
      name.empty() ? "a variable" : "the variable '" + name + "'");
}

// Writes the findings of a property program as a results.json (docs/results.md) with the one task
// of the session: its state, its promises with name, held, seconds and failures, its output, and
// whether it keeps a variable between calls. Fields that only the program `grade` can fill, such as
// words, points and replay, are left empty. Throws pt::Error if the file cannot be written.
void write_report(const std::string& path, const testing::UnitTest& test,
                  const wire::SessionSettings& settings, const wire::SessionRecord& record) {
  results::TaskResult task;
  task.slug = settings.task;
  task.printed = record.printed;
  for (int i = 0; i < test.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *test.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& promise = *suite.GetTestInfo(j);
      if (promise.should_run()) task.promises.push_back(describe(promise, settings.integrated));
    }
  }
  // In the integrated worker a variable may be another task's.
  task.keeps_state = record.kept != 0 && !settings.integrated;
  if (task.keeps_state) task.reason = kept_reason(settings.program, record.kept);
  task.state = state_of(task);
  if (record.todo.contains(settings.task)) {
    task.state = results::State::not_attempted;
    task.reason = "it is not written yet";
  }
  results::Results results;
  results.complete = true;
  results.seed = check::seed();
  results.tasks = {task};
  results::write_json(results::presentable(results), path);
}

}  // namespace

}  // namespace grader::programs

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

// Right solutions send less than a third of this (trace_path, with the records of its wild calls), in their properties or in a battery.
constexpr std::uint64_t kMaxAnswered = std::uint64_t{320} << 20;

int run_battery(const Options& options) {
  grader::wire::SessionSettings session = options.ask.session;
  session.call_limit = kBatteryCallLimit;
  session.total_limit = std::chrono::minutes(1);
  session.max_answered = kMaxAnswered * static_cast<std::uint64_t>(options.draws);
  session.give_up = [](grader::results::Cause cause, const std::string& how) {
    throw grader::mistakes::CallEnded{cause, how};
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
  // A submission that breaks a promise has its sentence already.
  const auto is_bonus = [](const grader::check::FailedPromise& each) {
    return each.promise.ends_with("_bonus");
  };
  if (std::ranges::all_of(grader::check::failures(), is_bonus)) {
    grader::wire::session().make_first_calls_again();
  }
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
  app.add_flag_callback("--no-wild", grader::check::never_wild,
                        "make no calls in scenes of any size");
  app.add_flag_callback("--single-precision", grader::check::allow_single_precision,
                        "take statistics in single precision for right");
  app.add_option("--battery", options.battery,
                 "run the battery instead: where to write the answers");
  app.add_option("--draws", options.draws, "draws of the battery: times the usual number")
      ->check(CLI::PositiveNumber);
  return grader::wire::run_asking(app, argc, argv, options.ask, [&] {
    return options.battery.empty() ? run(options, argv[0]) : run_battery(options);
  });
}
