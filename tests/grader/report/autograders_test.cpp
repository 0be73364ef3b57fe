// Files for platforms keep the rules of the platforms, and say what the other reports say.
#include "grader/report/autograders.h"

#include "grader/results/summary.h"
#include "tests/grader/report/example_run.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tinyxml2.h>

namespace grader::report {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Autograders : public ExampleRun {};

TEST_F(Autograders, gradescope_gets_a_test_a_task) {
  for (const results::Results& results : {run, stopped()}) {
    const json whole = json::parse(to_gradescope(results));
    EXPECT_EQ(whole.at("tests").size(), run.tasks.size());
    double score = 0;
    for (const json& test : whole.at("tests")) {
      score += test.at("score").get<double>();
      EXPECT_TRUE(test.at("max_score").is_number());
      EXPECT_TRUE(test.at("status") == "passed" || test.at("status") == "failed");
      EXPECT_EQ(test.at("visibility"), "visible");
      EXPECT_EQ(test.at("output_format"), "text");
      EXPECT_TRUE(test.at("tags").is_array());
      EXPECT_FALSE(test.at("output").get<std::string>().empty());
    }
    EXPECT_EQ(whole.at("score"), score);
    EXPECT_EQ(score, 2 + 1 + 1 + 1 + 1 + 0 + 2 + 6 + 0 + 5);  // with a bonus of 1
    EXPECT_EQ(whole.at("execution_time"), 27);
    EXPECT_EQ(whole.at("visibility"), "visible");
    EXPECT_EQ(whole.at("stdout_visibility"), "hidden");
    const std::string output = whole.at("output");
    EXPECT_EQ(output.find(results::kStopped) != std::string::npos, !results.complete);
    EXPECT_THAT(output, HasSubstr("A: bubblewrap"));
  }
}

TEST_F(Autograders, gradescope_tells_of_failures) {
  const json tests = json::parse(to_gradescope(run)).at("tests");
  EXPECT_EQ(tests[0].at("status"), "passed");
  EXPECT_EQ(tests[1].at("number"), "1.3");
  EXPECT_EQ(tests[1].at("status"), "failed");
  EXPECT_THAT(tests[1].at("output").get<std::string>(), HasSubstr("expected  1\n"));
  EXPECT_THAT(tests[4].at("output").get<std::string>(), HasSubstr("is a link"));
  EXPECT_THAT(tests[5].at("output").get<std::string>(), HasSubstr("waits for hit_box"));
  EXPECT_THAT(tests[6].at("output").get<std::string>(), HasSubstr(run.tasks[6].pictures[1].text));
  for (const json& test : tests) {
    EXPECT_THAT(test.at("output").get<std::string>(), Not(HasSubstr("\x1b")));
  }
}

TEST_F(Autograders, gradescope_shows_no_red_for_right_work_that_waits) {
  results::Results results = run;
  results::TaskResult& waiting = results.tasks[5];
  ASSERT_EQ(waiting.state, results::State::blocked);
  waiting.max_points = 3;
  for (const auto& [points, status] : {std::pair{3, "passed"}, std::pair{2, "failed"}}) {
    waiting.points = points;
    EXPECT_EQ(json::parse(to_gradescope(results)).at("tests")[5].at("status"), status);
  }
}

TEST_F(Autograders, gradescope_gives_no_points_for_what_is_not_judged) {
  const json whole = json::parse(to_gradescope(half_judged()));
  const json &lit = whole.at("tests")[6], &unwritten = whole.at("tests")[7];
  for (const json* test : {&lit, &unwritten}) {
    EXPECT_EQ(test->at("status"), "failed");
    EXPECT_EQ(test->at("extra_data").at("state"), "not_judged");
    EXPECT_THAT(test->at("output").get<std::string>(), HasSubstr("? not judged\n"));
  }
  EXPECT_EQ(lit.at("score"), 5);
  EXPECT_THAT(
      lit.at("output").get<std::string>(),
      HasSubstr("2 of 2 promises are kept; 1 of 5 pictures are right, 4 are not judged yet."));
  EXPECT_EQ(unwritten.at("score"), 0);
  EXPECT_THAT(unwritten.at("output").get<std::string>(),
              HasSubstr("0 of 2 promises are kept, 2 are not judged yet."));
  EXPECT_THAT(whole.at("output").get<std::string>(),
              HasSubstr("1 of 9 tasks pass, 3 not judged yet. "));
}

// PrairieLearn (makeGradingResult in externalGraderCommon.ts, and pl-external-grader-results.py):
// `score` is a number, at most 1; every test has `points` and `max_points`, else none is shown.
TEST_F(Autograders, prairielearn_gets_a_share_and_a_test_a_task) {
  for (const results::Results& results : {run, half_judged()}) {
    const json whole = json::parse(to_prairielearn(results));
    EXPECT_EQ(whole.at("gradable"), true);
    EXPECT_TRUE(whole.at("output").is_string());
    ASSERT_EQ(whole.at("tests").size(), run.tasks.size() + 1);
    EXPECT_EQ(whole.at("tests").back().at("name"), "bonus");
    double points = 0, most = 0;
    for (const json& test : whole.at("tests")) {
      const double of_test = test.at("points"), most_of_test = test.at("max_points");
      EXPECT_LE(of_test, most_of_test);  // else PrairieLearn shows it as wrong
      points += of_test;
      EXPECT_TRUE(test.at("name").is_string());
      if (test.at("name") == "bonus") continue;
      most += most_of_test;
      EXPECT_TRUE(test.at("output").is_string());
    }
    EXPECT_DOUBLE_EQ(whole.at("score").get<double>(), points / most);
  }
  results::Results all = run;
  for (results::TaskResult& task : all.tasks) task.points = task.max_points, task.bonus_points = 1;
  EXPECT_EQ(json::parse(to_prairielearn(all)).at("score"), 1);
  all.tasks.clear();
  EXPECT_EQ(json::parse(to_prairielearn(all)).at("score"), 0);
  EXPECT_TRUE(json::parse(to_prairielearn(all)).at("tests").empty());
}

// It takes 1 MB (docs/externalGrading.md).
TEST_F(Autograders, prairielearn_gets_no_more_than_it_takes) {
  results::Results large = run;
  for (results::TaskResult& task : large.tasks) {
    results::PromiseResult promise{"keeps_it", "keeps it", false, false, 1, 0, {}};
    promise.failures.assign(2, {});
    for (results::Failure& failure : promise.failures)
      failure.what = std::string(8000, '"') + "\n\u2212";
    task.state = results::State::fail;
    task.promises.assign(8, promise);
  }
  while (large.tasks.size() < 12) large.tasks.push_back(large.tasks[0]);
  const std::string text = to_prairielearn(large);
  EXPECT_LT(text.size(), 1000000);
  EXPECT_THAT(text, HasSubstr("The rest is left out."));
}

// Autolab (saveAutograde in assessment_autograde_core.rb, parseFeedback in assessments_controller.rb):
// the last line has the scores, and the line above it the stages, each of which is a table.
TEST_F(Autograders, autolab_gets_two_lines_at_the_end) {
  for (const results::Results& results : {run, half_judged()}) {
    std::vector<std::string> lines;
    std::istringstream text(to_autolab(results));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    ASSERT_GT(lines.size(), 10);
    const json scores = json::parse(lines.back()).at("scores");
    const json stages = json::parse(lines[lines.size() - 2]);
    EXPECT_EQ(stages.at("_presentation"), "semantic");
    std::size_t count = 0;
    for (const json& stage : stages.at("stages")) {
      for (const auto& [slug, shown] : stages.at(stage.get<std::string>()).items()) {
        const auto task = std::ranges::find(results.tasks, slug, &results::TaskResult::slug);
        ASSERT_NE(task, results.tasks.end());
        EXPECT_EQ(scores.at(slug), task->points + task->bonus_points);
        EXPECT_EQ(shown.at("passed").get<bool>(), !shown.contains("hint"));
        EXPECT_EQ(shown.at("passed"),
                  task->state == results::State::pass ||
                      (task->state == results::State::blocked && task->points >= task->max_points));
        ++count;
      }
    }
    EXPECT_EQ(count, run.tasks.size());
    EXPECT_EQ(scores.size(), run.tasks.size());
  }
}

// Artemis (TestResultXmlParser.java): of a suite at the top the name does not count. A test fails if
// it has a `failure`, and none may be called like another.
TEST_F(Autograders, artemis_gets_a_test_for_whatever_has_points) {
  results::Results integrated =
      run;  // a promise that breaks only with the submission's other tasks
  results::PromiseResult& promise = integrated.tasks[0].promises[0];
  promise.held = false;
  promise.failures.resize(1);
  promise.failures[0].integrated = true;
  for (const results::Results& results : {run, half_judged(), integrated}) {
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(to_artemis(results).c_str()), tinyxml2::XML_SUCCESS);
    const tinyxml2::XMLElement* suite = document.RootElement();
    ASSERT_STREQ(suite->Name(), "testsuite");
    std::set<std::string> passed, failed;
    for (auto test = suite->FirstChildElement(); test; test = test->NextSiblingElement()) {
      ASSERT_STREQ(test->Name(), "testcase");
      const auto failure = test->FirstChildElement("failure");
      EXPECT_TRUE((failure ? failed : passed).insert(test->Attribute("name")).second);
      EXPECT_TRUE(failure == nullptr || !std::string(failure->GetText()).empty());
    }
    for (const results::TaskResult& task : results.tasks) {
      for (const results::PromiseResult& each : task.promises) {
        const std::string name = task.slug + " " + each.name;
        EXPECT_EQ(passed.contains(name),
                  each.held || (!each.failures.empty() && each.failures[0].integrated))
            << name;
        EXPECT_EQ(failed.contains(name), !passed.contains(name) && !each.bonus) << name;
      }
      for (const results::PictureResult& each : task.pictures) {
        const std::string name = task.slug + " picture " + each.recipe;
        EXPECT_EQ(passed.contains(name), each.points == each.max_points) << name;
        EXPECT_NE(passed.contains(name), failed.contains(name)) << name;
      }
    }
    EXPECT_EQ(failed.contains("the run ends"), !results.complete);
  }
}

}  // namespace
}  // namespace grader::report
