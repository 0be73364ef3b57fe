#include "grader/programs/graded_report.h"

#include "grader/check/property.h"
#include "pt/error.h"

#include <fstream>

#include <nlohmann/json.hpp>

namespace grader::programs {

namespace {

using nlohmann::json;

json describe(const check::Failure& failure) {
  return {{"input", failure.input},
          {"what", failure.what},
          {"got", failure.got},
          {"expected", failure.expected},
          {"off_by", failure.off_by},
          {"cause", name(failure.cause)},
          {"cases_before", failure.cases_before},
          {"seed", failure.seed}};
}

json describe(const testing::TestInfo& promise) {
  json failed = json::array();
  for (const check::Failure& failure : check::failures()) {
    if (failure.promise == promise.name()) failed.push_back(describe(failure));
  }
  return {{"name", promise.name()},
          {"held", promise.result()->Passed()},
          {"seconds", static_cast<double>(promise.result()->elapsed_time()) * 1e-3},
          {"failures", failed}};
}

}  // namespace

void write_report(const std::string& path, const testing::UnitTest& test,
                  const wire::SessionRecord& record) {
  json promises = json::array();
  for (int i = 0; i < test.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *test.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& promise = *suite.GetTestInfo(j);
      if (promise.should_run()) promises.push_back(describe(promise));
    }
  }
  const json report{{"promises", promises}, {"todo", record.todo},   {"printed", record.printed},
                    {"kept", record.kept},  {"calls", record.calls}, {"restarts", record.restarts}};
  std::ofstream file(path);
  file << report.dump(1, ' ', false, json::error_handler_t::replace) << '\n';
  if (!file.flush()) throw pt::Error(path + ": cannot be written");
}

}  // namespace grader::programs
