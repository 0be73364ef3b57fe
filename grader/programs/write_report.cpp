#include "grader/programs/write_report.h"

#include "grader/base/printable.h"
#include "grader/check/language/property.h"
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "grader/service/audit/object_file.h"
#include "pt/file.h"

#include <cstdlib>
#include <memory>

#include <cxxabi.h>
#include <fmt/format.h>

namespace grader::programs {

namespace {

results::PromiseResult describe(const testing::TestInfo& promise, bool integrated) {
  results::PromiseResult result;
  result.name = promise.name();
  result.bonus = result.name.ends_with("_bonus");
  result.held = promise.result()->Passed();
  result.seconds = static_cast<double>(promise.result()->elapsed_time()) * 1e-3;
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

std::string kept_reason(const std::string& worker, std::uint64_t place) {
  const std::string name = variable_at(worker, place);
  return fmt::format(
      "it keeps {} between calls, and tasks are called from several threads at once: "
      "make it a local variable, a constant, or thread_local",
      name.empty() ? "a variable" : "the variable '" + name + "'");
}

}  // namespace

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
  if (task.keeps_state) task.reason = kept_reason(settings.program, record.kept - 1);
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

}  // namespace grader::programs
