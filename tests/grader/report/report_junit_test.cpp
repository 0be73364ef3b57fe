// JUnit's XML follows the rules of its readers.
#include "grader/report/junit.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "tests/grader/report/example_run.h"

#include <cstdio>
#include <cstdlib>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace grader::results {
namespace {

using testing::HasSubstr;
using testing::Not;

class JUnit : public ExampleRun {};

// Returns the number of elements of each name below `parent`.
std::map<std::string, int> children(const tinyxml2::XMLElement& parent) {
  std::map<std::string, int> names;
  for (const auto* each = parent.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    ++names[each->Name()];
  }
  return names;
}

// The rules of the schema that CI systems share (tests/grader/report/junit.xsd), and more: counts
// are exact; every testcase has a name, a class, a time and at most one reason for not passing.
void check_junit(const std::string& text) {
  if (std::system("xmllint --version >/dev/null 2>&1") == 0) {
    FILE* pipe = popen("xmllint --noout --schema '" FIRSTLIGHT_ROOT
                       "/tests/grader/report/junit.xsd' - 2>/dev/null",
                       "w");
    std::fputs(text.c_str(), pipe);
    EXPECT_EQ(pclose(pipe), 0) << "xmllint refuses\n" << text;
  }
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(text.data(), text.size()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  const auto* root = document.RootElement();
  ASSERT_STREQ(root->Name(), "testsuites");
  std::map<std::string, int> all;
  for (const auto* suite = root->FirstChildElement(); suite != nullptr;
       suite = suite->NextSiblingElement()) {
    ASSERT_STREQ(suite->Name(), "testsuite");
    EXPECT_NE(suite->Attribute("name"), nullptr);
    EXPECT_GE(suite->DoubleAttribute("time", -1), 0);
    std::map<std::string, int> found;
    for (const auto* test = suite->FirstChildElement(); test != nullptr;
         test = test->NextSiblingElement()) {
      ASSERT_STREQ(test->Name(), "testcase");
      for (const char* needed : {"name", "classname"}) {
        ASSERT_NE(test->Attribute(needed), nullptr);
        EXPECT_STRNE(test->Attribute(needed), "");
      }
      EXPECT_GE(test->DoubleAttribute("time", -1), 0);
      ++found["tests"];
      const std::map<std::string, int> outcomes = children(*test);
      ASSERT_LE(outcomes.size(), 1U);
      for (const auto& [name, count] : outcomes) {
        EXPECT_EQ(count, 1);
        ++found[name == "failure" ? "failures" : name == "error" ? "errors" : name];
        EXPECT_STRNE(test->FirstChildElement()->Attribute("message"), "");
      }
    }
    EXPECT_GE(found["tests"], 1);
    for (const char* count : {"tests", "failures", "errors", "skipped"}) {
      EXPECT_EQ(suite->IntAttribute(count, -1), found[count]) << suite->Attribute("name") << count;
      all[count] += found[count];
    }
    EXPECT_EQ(found.size(), 4U) << "an element that nobody knows";
  }
  for (const char* count : {"tests", "failures", "errors"}) {
    EXPECT_EQ(root->IntAttribute(count, -1), all[count]) << count;
  }
}

const tinyxml2::XMLElement* testcase(const tinyxml2::XMLDocument& document, const std::string& name,
                                     const std::string& class_name) {
  for (const auto* suite = document.RootElement()->FirstChildElement(); suite != nullptr;
       suite = suite->NextSiblingElement()) {
    for (const auto* test = suite->FirstChildElement(); test != nullptr;
         test = test->NextSiblingElement()) {
      if (name == test->Attribute("name") && class_name == test->Attribute("classname"))
        return test;
    }
  }
  return nullptr;
}

TEST_F(JUnit, keeps_the_rules) {
  check_junit(report::to_junit(run));
  check_junit(report::to_junit(stopped()));
  check_junit(report::to_junit(half_judged()));
  check_junit(report::to_junit(full_results()));
}

TEST_F(JUnit, has_a_way_of_not_passing_for_every_state) {
  for (const State state : kStates) {
    Results results = run;
    results.tasks.resize(1);
    results.tasks[0].state = state;
    results.tasks[0].pictures = run.tasks[6].pictures;
    results.tasks[0].pictures.resize(1);
    results.tasks[0].pictures[0].state = state;
    const std::string text = report::to_junit(results);
    check_junit(text);
    tinyxml2::XMLDocument document;
    document.Parse(text.c_str());
    const auto* root = document.RootElement();
    const bool skips =
        state == State::not_attempted || state == State::blocked || state == State::not_judged;
    const bool fails = state == State::fail || state == State::too_noisy;
    const bool errs = state == State::crash || state == State::timeout || state == State::rejected;
    EXPECT_EQ(root->FirstChildElement()->IntAttribute("skipped") > 0, skips) << name(state);
    EXPECT_EQ(root->IntAttribute("failures") > 0, fails) << name(state);
    EXPECT_EQ(root->IntAttribute("errors") > 0, errs) << name(state);
  }
}

TEST_F(JUnit, holds_the_failure) {
  tinyxml2::XMLDocument document;
  const std::string text = report::to_junit(run);
  document.Parse(text.c_str());
  const std::string promise = run.tasks[1].promises[1].name;
  const auto* wrong = testcase(document, promise, "1_rays.hit_triangle")->FirstChildElement();
  EXPECT_STREQ(wrong->Name(), "failure");
  EXPECT_THAT(wrong->GetText(), HasSubstr("triangle {(0, 0, 0), (1, 0, 0), (0, 1, 0)}"));
  const auto* dead = testcase(document, promise, "1_rays.hit_sphere")->FirstChildElement();
  EXPECT_STREQ(dead->Name(), "error");
  EXPECT_STREQ(dead->Attribute("type"), "crash");
  const auto* picture =
      testcase(document, "picture penumbra", "3_direct.direct_lights")->FirstChildElement();
  EXPECT_STREQ(picture->Attribute("message"), run.tasks[6].pictures[1].text.c_str());
  EXPECT_EQ(document.RootElement()->Attribute("name"), presentable(kHostile));
  EXPECT_THAT(report::to_junit(stopped()), HasSubstr(kStopped));
  EXPECT_THAT(text, Not(HasSubstr(kStopped)));
}

TEST_F(JUnit, skips_what_is_not_judged) {
  tinyxml2::XMLDocument document;
  document.Parse(report::to_junit(half_judged()).c_str());
  const std::string promise = run.tasks[6].promises[0].name;
  EXPECT_EQ(testcase(document, promise, "3_direct.direct_lights")->FirstChildElement(), nullptr);
  for (const auto& [name, class_name] :
       {std::pair<std::string, std::string>{"picture penumbra", "3_direct.direct_lights"},
        {promise, "4_global.trace_path"},
        {promise, "5_adaptive.adaptive_pixel"}}) {
    const auto* skipped = testcase(document, name, class_name)->FirstChildElement();
    ASSERT_NE(skipped, nullptr) << class_name;
    EXPECT_STREQ(skipped->Name(), "skipped");
    EXPECT_STREQ(skipped->Attribute("message"), "not judged");
  }
  EXPECT_STREQ(testcase(document, "ends", "run")->FirstChildElement()->Name(), "error");
}

TEST_F(JUnit, says_what_the_compiler_said) {
  Results results = run;
  TaskResult& task = results.tasks[1];
  task.reason = "The file does not compile.";
  task.compiler_output = "hit_triangle.cpp:7: error: expected ';'";
  for (PromiseResult& promise : task.promises) {
    promise.held = false;
    promise.failures.clear();
  }
  EXPECT_THAT(report::to_junit(results), HasSubstr("hit_triangle.cpp:7: error: expected"));
  task.promises.clear();
  check_junit(report::to_junit(results));
  EXPECT_THAT(report::to_junit(results), HasSubstr("hit_triangle.cpp:7: error: expected"));
}

}  // namespace
}  // namespace grader::results
