// Four bugs from a write-up of the course, which its author found by looking at pictures. Each fails a
// property and a picture in its own task, and nothing in any other task. docs/four_bugs.md shows our
// report on each.
#include "grader/tasks.h"
#include "tests/fixtures/hostile_submission.h"
#include "tests/fixtures/task_folder.h"

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

struct Bug {
  const char* title;
  const char* task;
  const char* mistake;  // in grader/tasks/<task>/mistakes.txt
  const char* promise;  // the promise that it breaks
  const char* recipe;   // the recipe that shows it well
};

constexpr std::array<Bug, 4> kFourBugs{{
    {"The box test overwrites the ray's range", "hit_bvh", "range_overwritten",
     "finds_the_nearest_hit", "bvh_coil"},
    {"Children joined by a short-circuit", "hit_bvh", "first_child_that_hits",
     "finds_the_nearest_hit", "bvh_coil"},
    {"The BSDF applied twice", "trace_path", "bsdf_applied_twice", "matches_the_furnace",
     "global_indirect"},
    {"The running total taken for the sample", "adaptive_pixel", "running_total_as_the_sample",
     "stops_where_the_interval_is_narrow", "adaptive_fine"},
}};

// The reference with this bug.
void put(const Bug& bug, const Submission& submission) {
  submission.replace(bug.task, kept_solution(FIRSTLIGHT_ROOT, bug.task, "wrong", bug.mistake).file);
}

using nlohmann::json;

const json& named(const json& all, const char* member, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const json& each) { return each.at(member) == name; });
  static const json none;
  return found == all.end() ? none : *found;
}

bool waits_for(const json& task, const std::string& slug) {
  const json& by = task.at("blocked_by");
  return task.at("state") == "blocked" && std::find(by.begin(), by.end(), slug) != by.end();
}

class FourBugs : public testing::TestWithParam<Bug> {};

TEST_P(FourBugs, is_found_by_a_property_in_its_own_task_only) {
  const Submission submission("bug");
  put(GetParam(), submission);
  const Outcome outcome = submission.grade({"--no-pictures"}, kLongLimit);
  EXPECT_EQ(outcome.exit_status, 1);
  ASSERT_EQ(outcome.results.at("tasks").size(), tasks().size());
  for (const json& task : outcome.results.at("tasks")) {
    if (task.at("slug") == GetParam().task) {
      EXPECT_EQ(task.at("state"), "fail");
      const json& promise = named(task.at("promises"), "name", GetParam().promise);
      ASSERT_FALSE(promise.is_null());
      EXPECT_EQ(promise.at("held"), false);
      EXPECT_FALSE(promise.at("failures").at(0).at("input").empty());
      // A mistake that has a name is shown by its own promise.
      EXPECT_EQ(task.at("mistake").at("name"), GetParam().mistake);
      for (const json& each : task.at("promises")) {
        EXPECT_EQ(each.at("likeness"), each == promise ? 1 : 0) << each.at("name");
      }
    } else {
      EXPECT_TRUE(task.at("state") == "pass" || waits_for(task, GetParam().task)) << task.dump(1);
    }
  }
}

TEST_P(FourBugs, is_seen_in_its_picture) {
  const Submission submission("bug");
  put(GetParam(), submission);
  const Outcome outcome = submission.grade({GetParam().task}, kLongLimit);
  const json& task = outcome.task(GetParam().task);
  ASSERT_FALSE(task.is_null()) << outcome.output;
  EXPECT_EQ(task.at("state"), "fail");
  const json& picture = named(task.at("pictures"), "recipe", GetParam().recipe);
  ASSERT_FALSE(picture.is_null());
  EXPECT_EQ(picture.at("state"), "fail");
  EXPECT_NE(picture.at("text"), "");
}

INSTANTIATE_TEST_SUITE_P(All, FourBugs, testing::ValuesIn(kFourBugs),
                         [](const auto& bug) { return std::string(bug.param.mistake); });

}  // namespace
}  // namespace grader::tests
