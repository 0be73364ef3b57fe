// Points: the worth of promises and pictures, and the cost of one cause.
#include "grader/results/points.h"

#include "grader/service/judging/grade.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::results {
namespace {

using testing::HasSubstr;

// A task with this many promises; the first ones are broken.
TaskResult example(int promises, int broken) {
  TaskResult task;
  task.slug = "hit_box";
  for (int i = 0; i < promises; ++i) {
    task.promises.push_back({"p" + std::to_string(i), "words", false, i >= broken, 0, 0, {}});
  }
  return task;
}

PictureResult picture(const std::string& recipe, State state) {
  PictureResult out;
  out.recipe = recipe;
  out.state = state;
  return out;
}

TaskResult counted(TaskResult task, const TaskPoints& points) {
  count_points({{"hit_box", points}}, task);
  return task;
}

TEST(points, count_promises_by_their_weight) {
  TaskPoints points;
  points.promise = 2;
  points.promises = {{"p0", 5}, {"p2", 0}};
  const TaskResult task = counted(example(4, 1), points);
  EXPECT_EQ(task.max_points, 5 + 2 + 0 + 2);
  EXPECT_EQ(task.points, 2 + 0 + 2);
  EXPECT_EQ(task.promises[0].points, 5);
}

TEST(points, of_a_bonus_come_on_top) {
  TaskResult task = example(3, 0);
  task.promises[1].bonus = task.promises[2].bonus = true;
  task.promises[2].held = false;
  task = counted(task, {});
  EXPECT_EQ(task.points, 1);
  EXPECT_EQ(task.max_points, 1);
  EXPECT_EQ(task.bonus_points, 1);
}

TEST(points, of_pictures_depend_on_their_state) {
  TaskPoints points;
  points.picture = 3;
  points.too_noisy = 2;
  points.pictures = {{"small", 1}};
  TaskResult task = example(1, 0);
  task.pictures = {picture("a", State::pass), picture("b", State::too_noisy),
                   picture("c", State::fail), picture("small", State::too_noisy)};
  task = counted(task, points);
  EXPECT_EQ(task.max_points, 1 + 3 + 3 + 3 + 1);
  EXPECT_EQ(task.points, 1 + 3 + 2 + 0 + 1);  // no more for low noise than for a right result
}

// Another task's mistake counts there.
TEST(points, are_kept_by_what_is_right_with_the_reference_elsewhere) {
  Failure together;
  together.integrated = true;
  TaskResult task = example(4, 3);
  task.promises[0].failures = {together, together};
  task.promises[1].failures = {together, {}};  // also by itself
  task.pictures = {picture("a", State::fail), picture("b", State::too_noisy),
                   picture("c", State::fail)};
  task.pictures[0].integrated = task.pictures[1].integrated = true;
  TaskPoints points;
  points.picture = 3;
  task = counted(task, points);
  EXPECT_EQ(task.points, 2 + 2 + 2);  // each picture has the share of the promises: half
  EXPECT_EQ(task.max_points, 4 + 9);
}

// A picture can be copied from its golden; promises cannot.
TEST(points, of_a_picture_are_at_most_the_share_that_promises_earn) {
  TaskPoints points;
  points.picture = 3;
  points.too_noisy = 1;
  for (const auto& [broken, each] : {std::pair{0, 3}, {1, 3}, {6, 2}, {8, 1}, {11, 0}, {12, 0}}) {
    TaskResult task = example(12, broken);
    task.pictures = {picture("a", State::pass), picture("b", State::too_noisy)};
    task = counted(task, points);
    EXPECT_EQ(task.pictures[0].points, each) << broken;
    EXPECT_EQ(task.pictures[1].points, std::min(1, each)) << broken;
    EXPECT_EQ(task.max_points, 12 + 3 + 3) << broken;
  }
  TaskResult pictures_alone = example(0, 0);
  pictures_alone.pictures = {picture("a", State::pass)};
  EXPECT_EQ(counted(pictures_alone, points).points, 3);
}

TEST(points, that_one_named_cause_takes_are_bounded) {
  TaskPoints half;
  half.one_cause = 0.5;
  for (int promises = 1; promises <= 15; ++promises) {
    for (int broken = 0; broken <= promises; ++broken) {
      TaskResult task = example(promises, broken);
      EXPECT_EQ(counted(task, half).points, promises - broken);
      EXPECT_EQ(counted(task, half).spared, 0);
      task.mistake = {"absolute_epsilon", "It is an epsilon.", "battery", "", false};
      const int most = (promises + 1) / 2;  // rounded up
      const int kept = promises - broken;
      task = counted(task, half);
      EXPECT_EQ(task.spared, std::min(std::max(0, broken - most), kept));
      EXPECT_EQ(task.points, kept + task.spared);
      EXPECT_EQ(task.max_points, promises);
    }
  }
}

// A task whose every call crashes may look exactly like a known mistake.
TEST(points, are_not_given_back_to_a_task_that_keeps_no_promise) {
  TaskPoints free;
  free.one_cause = 0;
  TaskResult task = example(6, 6);
  task.promises[5].bonus = task.promises[5].held = true;  // a bonus earns nothing back
  task.mistake = {"missing_return", "The sum is never returned.", "battery", "", false};
  EXPECT_EQ(counted(task, free).points, 0);
  task.promises[0].held = true;
  EXPECT_EQ(counted(task, free).points, 2);
  task.mistake.always_the_same = true;
  EXPECT_EQ(counted(task, free).points, 1);
}

TEST(points, of_one_cause_are_a_share_of_the_weights) {
  TaskPoints points;
  points.one_cause = 0.1;
  points.promise = 3;
  points.promises = {{"p0", 9}};
  TaskResult task = example(8, 2);  // 9 + 7 * 3 = 30 points, 12 of them lost
  task.promises[7].bonus = true;    // 27
  task.mistake.name = "a";
  EXPECT_EQ(counted(task, points).spared, 12 - 3);  // 2.7, rounded up
  task.promises[7].bonus = false;
  EXPECT_EQ(counted(task, points).spared, 12 - 3);  // exactly 3
  points.one_cause = 1;
  EXPECT_EQ(counted(task, points).spared, 0);
  points.one_cause = 0;
  EXPECT_EQ(counted(task, points).spared, 12);
}

// A dialect bounds the cost of a cause that the judge has named. A name that the submission may have printed changes nothing.
// Two promises crash alike, a third in another way; two fail by the same answer to the same input, and one by the same to another.
TEST(points, of_promises_that_are_broken_for_the_same_reason_count_once) {
  const auto broken = [](const std::string& got, Cause cause, const std::string& input) {
    PromiseResult promise;
    promise.failures.push_back({.input = {input}, .got = got, .cause = cause});
    return promise;
  };
  PromiseResult kept;
  kept.held = true;
  TaskResult task;
  task.slug = "hit_box";
  task.promises = {broken("endless", Cause::crash, "x"),
                   broken("endless", Cause::crash, "y"),
                   broken("signal", Cause::crash, "x"),
                   broken("2", Cause::wrong, "x"),
                   broken("2", Cause::wrong, "x"),
                   broken("2", Cause::wrong, "y"),
                   kept,
                   kept};
  TaskPoints points;
  points.one_cause = 0.5;
  EXPECT_EQ(counted(task, points).spared, 2);
  task.promises[1].failures.push_back(task.promises[3].failures[0]);  // another reason as well
  EXPECT_EQ(counted(task, points).spared, 1);
  task.promises.pop_back();
  task.promises.pop_back();
  EXPECT_EQ(counted(task, points).spared, 0);  // no promise is kept
  task.promises.push_back(kept);
  points.one_cause = 1;
  EXPECT_EQ(counted(task, points).spared, 0);
}

TEST(points, that_one_cause_of_a_dialect_takes_are_those_of_one_promise) {
  TaskPoints points;
  points.promise = 3;
  points.promises = {{"p0", 9}};
  TaskResult task = example(4, 3);
  task.mistake = {"no_fallback", "It never ends.", kOneCause, "", false};
  EXPECT_EQ(counted(task, points).points, 9 + 3 + 3 + 3 - 9);
  task.promises[0].held = true;
  EXPECT_EQ(counted(task, points).points, 9 + 3 + 3 + 3 - 3);
  task.mistake.found_by = kNamedOnly;
  EXPECT_EQ(counted(task, points).points, 9 + 3);
}

TEST(points, of_pictures_and_bonuses_are_not_spared) {
  TaskPoints points;
  points.one_cause = 0;
  TaskResult task = example(2, 1);
  task.promises[0].bonus = true;
  task.pictures = {picture("a", State::fail)};
  task.mistake.name = "a";
  task = counted(task, points);
  EXPECT_EQ(task.spared, 0);
  EXPECT_EQ(task.points, 1);
  EXPECT_EQ(task.bonus_points, 0);
}

TEST(points, that_kept_state_costs_are_never_more_than_were_earned) {
  TaskPoints points;
  points.keeps_state = 3;
  TaskResult task = example(5, 0);
  task.keeps_state = true;
  EXPECT_EQ(counted(task, points).points, 5 - 3);
  task = example(5, 3);  // 2 points
  task.keeps_state = true;
  EXPECT_EQ(counted(task, points).points, 0);
  EXPECT_EQ(counted(task, points).max_points, 5);
}

std::string why_refused(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/points.json";
  pt::write_file(path, text);
  try {
    load_points(path);
  } catch (const pt::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("points.json:"));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("[json")));
    return error.what();
  }
  return "";
}

TEST(points, are_read_with_what_a_task_says_beside_the_defaults) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/points.json";
  pt::write_file(path, R"({"default": {"promise": 2, "picture": 4, "too_noisy": 1,
    "one_cause": 0.5}, "tasks": {"hit_box": {"promise": 3, "one_cause": 1,
    "promises": {"x": 7}, "pictures": {"y": 0}}}})");
  const Points points = load_points(path);
  ASSERT_EQ(points.size(), tasks().size());
  EXPECT_EQ(points.at("hit_sphere").promise, 2);  // it has no entry
  EXPECT_EQ(points.at("hit_sphere").picture, 4);
  EXPECT_EQ(points.at("hit_sphere").one_cause, 0.5);
  EXPECT_EQ(points.at("hit_box").promise, 3);
  EXPECT_EQ(points.at("hit_box").picture, 4);
  EXPECT_EQ(points.at("hit_box").one_cause, 1);
  EXPECT_EQ(points.at("hit_box").promises.at("x"), 7);
  EXPECT_EQ(points.at("hit_box").pictures.at("y"), 0);
}

TEST(points, are_one_for_a_promise_and_one_for_a_picture_if_the_file_says_nothing) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/points.json";
  pt::write_file(path, R"({"default": {}, "tasks": {"hit_box": {"promise": 2}}})");
  const Points points = load_points(path);
  for (const auto& [slug, task] : points) {
    EXPECT_EQ(task.promise, slug == "hit_box" ? 2 : 1);
    EXPECT_EQ(task.picture, 1);
    EXPECT_EQ(task.too_noisy, 0);
    EXPECT_EQ(task.keeps_state, 0);
    EXPECT_EQ(task.one_cause, 1);
  }
}

TEST(points, of_examples_are_a_bonus_and_not_those_of_a_promise) {
  TaskResult task;
  task.slug = "hit_box";
  task.promises.push_back({"first", "", false, true, 0, 0, {}});
  task.promises.push_back({"examples:first", "", true, true, 0, 0, {}});
  task.promises.push_back({"examples:second", "", true, false, 0, 0, {}});
  Points points{{"hit_box", {}}};
  count_points(points, task);
  EXPECT_EQ(task.bonus_points, 0);
  points["hit_box"].promise = 2;
  points["hit_box"].examples = 3;
  count_points(points, task);
  EXPECT_EQ(task.points, 2);
  EXPECT_EQ(task.max_points, 2);
  EXPECT_EQ(task.bonus_points, 3);
}

TEST(points, are_refused_with_what_is_wrong_and_where) {
  const auto task = [](const std::string& inside) {
    return R"({"default": {}, "tasks": {"hit_box": )" + inside + "}}";
  };
  EXPECT_THAT(why_refused(""), HasSubstr("points.json:1: this is not JSON"));
  EXPECT_THAT(why_refused("{\"default\": {},\n}"), HasSubstr("points.json:2: this is not JSON"));
  EXPECT_THAT(why_refused("[]"), HasSubstr("is not an object with default and tasks"));
  EXPECT_THAT(why_refused("{}"), HasSubstr("default"));
  EXPECT_THAT(why_refused(R"({"default": {}})"), HasSubstr("tasks"));
  EXPECT_THAT(why_refused(task("5")), HasSubstr("tasks.hit_box is not an object"));
  EXPECT_THAT(why_refused(task(R"({"promis": 1})")),
              HasSubstr("tasks.hit_box.promis means nothing; write promise, picture"));
  for (const char* number : {"-1", "1.5", "1001", "18446744073709551615", "\"1\"", "null"}) {
    EXPECT_THAT(why_refused(task(std::string(R"({"promise": )") + number + "}")),
                HasSubstr("tasks.hit_box.promise is not a whole number from 0 to 1000"));
    EXPECT_THAT(why_refused(task(std::string(R"({"pictures": {"x": )") + number + "}}")),
                HasSubstr("tasks.hit_box.pictures.x is not a whole number from 0 to 1000"));
  }
  EXPECT_THAT(why_refused(task(R"({"promises": [1]})")), HasSubstr("promises is not an object"));
  EXPECT_THAT(why_refused(R"({"default": {}, "tasks": {"hit_shpere": {}}})"),
              HasSubstr("tasks.hit_shpere is not a task; write one of estimate_pixel, camera_ray"));
  EXPECT_THAT(why_refused(R"({"default": {}, "tasks": [{}]})"),
              HasSubstr("tasks is not an object"));
  for (const char* share : {"-0.1", "1.01", "\"1\"", "null"}) {
    EXPECT_THAT(why_refused(task(std::string(R"({"one_cause": )") + share + "}")),
                HasSubstr("tasks.hit_box.one_cause is not a number from 0 to 1"));
  }
}

TEST(points, of_a_part_are_weighed_or_left_out) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/points.json";
  pt::write_file(path, R"({"parts": {"2_bvh": 3, "4_global": 0},
    "default": {"promise": 2, "picture": 4, "too_noisy": 1, "keeps_state": 5, "one_cause": 0.5},
    "tasks": {"hit_box": {"promises": {"x": 7}, "pictures": {"y": 2}}, "hit_sphere": {},
              "trace_path": {"pictures": {"z": 9}}}})");
  const Points points = load_points(path);
  const TaskPoints& box = points.at("hit_box");
  EXPECT_EQ(box.promise, 6);
  EXPECT_EQ(box.picture, 12);
  EXPECT_EQ(box.too_noisy, 3);
  EXPECT_EQ(box.keeps_state, 15);
  EXPECT_EQ(box.promises.at("x"), 21);
  EXPECT_EQ(box.pictures.at("y"), 6);
  EXPECT_EQ(box.one_cause, 0.5);
  EXPECT_EQ(points.at("hit_sphere").promise, 2);
  EXPECT_TRUE(is_left_out(points, "trace_path"));
  EXPECT_FALSE(is_left_out(points, "hit_box"));
  EXPECT_FALSE(is_left_out(points, "hit_sphere"));
}

// A task may get all its points from one promise or one picture.
TEST(points, of_one_promise_or_one_picture_are_enough_to_be_asked) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/points.json";
  pt::write_file(path, R"({"default": {"promise": 0, "picture": 0},
    "tasks": {"hit_box": {"promises": {"x": 1, "y": 0}}, "hit_sphere": {"pictures": {"z": 1}},
              "hit_bvh": {"promises": {"x": 0}, "pictures": {"z": 0}}}})");
  const Points points = load_points(path);
  EXPECT_FALSE(is_left_out(points, "hit_box"));
  EXPECT_FALSE(is_left_out(points, "hit_sphere"));
  EXPECT_TRUE(is_left_out(points, "hit_bvh"));
  EXPECT_TRUE(is_left_out(points, "hit_triangle"));
}

TEST(points, of_parts_are_refused_with_what_is_wrong) {
  const auto parts = [](const std::string& inside) {
    return R"({"default": {}, "tasks": {"hit_box": {}}, "parts": )" + inside + "}";
  };
  EXPECT_THAT(why_refused(parts(R"({"4": 1})")),
              HasSubstr("parts.4 is not a part of the course; write 1_rays, 2_bvh"));
  EXPECT_THAT(why_refused(parts(R"({"4_global": -1})")),
              HasSubstr("parts.4_global is not a whole number from 0 to 1000"));
}

// A run knows which names do not exist: promises are in the contract, pictures in the recipes.
TEST(points, name_promises_and_pictures_that_there_are) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  fs::create_directory(folder.path() + "/grader");
  for (const char* part : {"pt", "scenes", "golden"}) {
    fs::create_directory_symlink(std::string(FIRSTLIGHT_ROOT "/") + part,
                                 folder.path() + "/" + part);
  }
  build::Config config;
  config.root = folder.path();
  config.tasks = {{"1_rays", "1.4", "hit_sphere", "any", {}}};
  judging::GradeRequest request;
  request.submission = folder.path();
  request.asked = {"hit_sphere"};
  const auto why = [&](const std::string& entry) -> std::string {
    pt::write_file(folder.path() + "/grader/points.json",
                   R"({"default": {}, "tasks": {"hit_sphere": )" + entry + "}}");
    try {
      judging::grade(config, request, [](const Results&) { throw std::runtime_error("begun"); });
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(why(R"({"promises": {"never_fails": 2}})"),
              HasSubstr("points.json: never_fails is not a promise of its task"));
  EXPECT_THAT(why(R"({"pictures": {"a_cat": 2}})"),
              HasSubstr("points.json: a_cat is not a picture of its task"));
}

TEST(points, of_the_project_can_be_read) {
  const Points points = load_points(FIRSTLIGHT_ROOT "/grader/points.json");
  EXPECT_EQ(points.size(), tasks().size());
  EXPECT_EQ(points.at("hit_box").one_cause, 0.5);
}

}  // namespace
}  // namespace grader::results
