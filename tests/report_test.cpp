// Results that are written come back.
#include "grader/report/json.h"
#include "grader/report/read_json.h"
#include "pt/error.h"

#include <gtest/gtest.h>

namespace grader {
namespace {

// Every field has a value that it does not have by default and no other field has.
Results full_results() {
  const FailureReport failure{{"a", "b"}, "c", "d", "e", "f", "g", 1, 1ULL << 63, true, "h"};
  TaskResult task{.part = "i",
                  .number = "j",
                  .slug = "k",
                  .state = State::crash,
                  .reason = "l",
                  .points = 2,
                  .max_points = 3,
                  .bonus_points = 4,
                  .blocked_by = {"m"},
                  .blamed = {"n", "o"},
                  .compiler_output = "p\nq\n",
                  .printed = "\x1b\"r",
                  .promises = {{"s", "t", true, true, 0.1, {}}, {"u", "v", false, false, 0.2, {}}},
                  .pictures = {{"w", State::too_noisy, "x"}}};
  task.promises[1].failures = {failure, failure};
  return {"y", 5, "z", 0.3, true, {"aa", "bb"}, {task, task}};
}

TEST(report, what_is_written_comes_back) {
  const Results results = full_results();
  const std::string text = to_json(results);
  const Results back = results_from_json(text, "x");
  EXPECT_EQ(to_json(back), text);
  EXPECT_EQ(back.tasks.at(1).promises.at(1).failures.at(1).seed, 1ULL << 63);
  EXPECT_EQ(back.tasks[0].state, State::crash);
}

TEST(report, every_state_comes_back) {
  for (int i = 0; i <= static_cast<int>(State::rejected); ++i) {
    Results results = full_results();
    results.tasks[0].state = static_cast<State>(i);
    EXPECT_EQ(results_from_json(to_json(results), "x").tasks[0].state, static_cast<State>(i));
  }
}

TEST(report, what_is_no_report_is_refused) {
  EXPECT_THROW(results_from_json("", "x"), pt::Error);
  EXPECT_THROW(results_from_json("{}", "x"), pt::Error);
  std::string other = to_json(full_results());
  other.replace(other.find("\"schema_version\": 1"), 19, "\"schema_version\": 0");
  EXPECT_THROW(results_from_json(other, "x"), pt::Error);
}

}  // namespace
}  // namespace grader
