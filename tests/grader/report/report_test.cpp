// Results can be written and read back, and their texts are fit for every format.
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "pt/error.h"
#include "tests/grader/report/example_results.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace grader::results {
namespace {

TEST(report, what_is_written_comes_back) {
  const Results results = full_results();
  EXPECT_NE(results, Results{});
  EXPECT_EQ(results_from_json(to_json(results), "x"), results);
}

TEST(report, every_state_comes_back) {
  for (int i = 0; i <= static_cast<int>(State::not_judged); ++i) {
    Results results = full_results();
    results.tasks[0].state = static_cast<State>(i);
    EXPECT_EQ(results_from_json(to_json(results), "x").tasks[0].state, static_cast<State>(i));
  }
}

TEST(report, a_number_that_is_not_finite_comes_back_as_not_a_number) {
  Results results = full_results();
  results.tasks[0].pictures[0].noise = std::numeric_limits<double>::infinity();
  const Results back = results_from_json(to_json(results), "x");
  EXPECT_TRUE(std::isnan(back.tasks[0].pictures[0].noise));
}

TEST(report, a_file_with_fewer_members_is_read) {
  nlohmann::json older = nlohmann::json::parse(to_json(full_results()));
  for (const char* member : {"phases", "versions", "command"}) older.erase(member);
  for (nlohmann::json& task : older["tasks"]) task["pictures"] = nlohmann::json::array();
  const Results back = results_from_json(older.dump(), "x");
  EXPECT_EQ(back.tasks.at(1).promises, full_results().tasks[1].promises);
  EXPECT_TRUE(back.phases.empty());
}

TEST(report, only_a_whole_run_passes) {
  Results results = full_results();
  for (TaskResult& task : results.tasks) task.state = State::pass;
  EXPECT_EQ(nlohmann::json::parse(to_json(results)).at("passed"), true);
  results.complete = false;
  EXPECT_EQ(nlohmann::json::parse(to_json(results)).at("passed"), false);
}

// A crash is reported before a call that takes too long, and that before a wrong answer, in
// whatever order they come. A missed bonus is not a fault.
TEST(report, a_state_is_the_worst_of_the_promises) {
  const auto state = [](const std::vector<std::vector<Cause>>& promises, bool bonus = false) {
    TaskResult task;
    for (const std::vector<Cause>& causes : promises) {
      PromiseResult& promise = task.promises.emplace_back();
      promise.bonus = bonus;
      promise.held = causes.empty();
      for (const Cause cause : causes) promise.failures.emplace_back().cause = cause;
    }
    return state_of(task);
  };
  using enum Cause;
  EXPECT_EQ(state({}), State::pass);
  EXPECT_EQ(state({{}, {}}), State::pass);
  EXPECT_EQ(state({{}, {wrong}}), State::fail);
  EXPECT_EQ(state({{timeout}, {wrong}}), State::timeout);
  EXPECT_EQ(state({{wrong}, {timeout}}), State::timeout);
  EXPECT_EQ(state({{wrong, crash}, {timeout}}), State::crash);
  EXPECT_EQ(state({{timeout}, {wrong, crash}}), State::crash);
  EXPECT_EQ(state({{timeout}, {crash}}, true), State::pass);
}

// Grades are computed from these numbers.
TEST(report, points_that_do_not_fit_are_refused) {
  const auto refused = [](auto change) {
    nlohmann::json results = nlohmann::json::parse(to_json(full_results()));
    change(results["tasks"]);
    EXPECT_THROW(results_from_json(results.dump(), "x"), pt::Error) << results["tasks"].size();
  };
  refused([](nlohmann::json& tasks) { tasks[0]["points"] = -1; });
  refused(
      [](nlohmann::json& tasks) { tasks[0]["points"] = tasks[0]["max_points"].get<int>() + 1; });
  refused([](nlohmann::json& tasks) { tasks[0]["points"] = ~std::uint64_t{4}; });
  refused([](nlohmann::json& tasks) { tasks[0]["bonus_points"] = -1; });
  refused([](nlohmann::json& tasks) { tasks[0]["pictures"][0]["points"] = 100; });
  refused([](nlohmann::json& tasks) { tasks.push_back(tasks[0]); });
}

TEST(report, what_is_no_report_is_refused) {
  std::string other = to_json(full_results());
  other.replace(other.find("\"schema_version\": 2"), 19, "\"schema_version\": 0");
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[]"), other,
        std::string(R"({"schema_version": 2})"),
        std::string(R"({"schema_version": 2, "tasks": 5})"),
        std::string(R"({"schema_version": 2, "tasks": [5]})"),
        std::string(R"({"schema_version": 2, "tasks": [{"state": "perfect"}]})"),
        std::string(R"({"schema_version": 2, "tasks": [{"slug": 5}]})")}) {
    EXPECT_THROW(results_from_json(text, "x"), pt::Error) << text;
  }
}

TEST(presentable, leaves_plain_text_alone) {
  const std::string text = "a\tb\nc \u00e9 \u2713 \U0001f600 <&\"'";
  EXPECT_EQ(presentable(text), text);
}

TEST(presentable, replaces_what_is_no_text) {
  const std::string mark = "\uFFFD";
  EXPECT_EQ(presentable("a\x1b[31m"), "a" + mark + "[31m");
  EXPECT_EQ(presentable(std::string("a\0b\x7f", 4)), "a" + mark + "b" + mark);
  EXPECT_EQ(presentable("\xff\xfe"), mark + mark);
  EXPECT_EQ(presentable("\xc2\x9b"), mark);                                // a control of 8 bits
  EXPECT_EQ(presentable("\u202Eab\u2066"), mark + "ab" + mark);            // turns the direction
  EXPECT_EQ(presentable("\xef\xbf\xbe\xef\xbf\xbf"), mark + mark);         // not characters in XML
  EXPECT_EQ(presentable("\xed\xa0\x80").find('\xed'), std::string::npos);  // half a surrogate pair
}

TEST(presentable, cuts_long_texts_and_lists_between_characters) {
  std::string text;
  while (text.size() < 3 * kMaxText) text += "\u2713";
  const std::string cut = presentable(text);
  EXPECT_LE(cut.size(), kMaxText);
  EXPECT_GT(cut.size(), kMaxText / 2);
  EXPECT_EQ(cut.find("\uFFFD"), std::string::npos);
  const std::size_t kept = cut.find(" ...");
  EXPECT_EQ(cut.substr(kept), " ... (" + std::to_string(text.size() - kept) + " bytes more)");
  EXPECT_EQ(presentable(cut), cut);

  Results results = full_results();
  results.tasks[1].promises[1].failures.resize(5000);
  results.tasks[1].promises[1].failures[7].input = {text};
  results = presentable(results);
  EXPECT_EQ(results.tasks[1].promises[1].failures.size(), kMaxList);
  EXPECT_EQ(results.tasks[1].promises[1].failures[7].input[0], cut);
  EXPECT_EQ(presentable(results), results);
}

}  // namespace
}  // namespace grader::results
