// The report on a task whose run has not ended.
#include "grader/service/judging/so_far.h"

#include "grader/results/points.h"
#include "grader/service/judging/grade.h"
#include "pt/error.h"

#include <gtest/gtest.h>

namespace grader::judging {
namespace {

// The task is right by itself, with two promises kept and two pictures to come.
Judged example() {
  Judged judged;
  judged.result.slug = "trace_path";
  judged.result.state = results::State::pass;
  judged.right_alone = true;
  for (const char* name : {"a", "b"}) {
    judged.result.promises.push_back({name, "words", false, true, 1, 0, {}});
    judged.result.pictures.emplace_back().recipe = name;
  }
  return judged;
}

int points(results::TaskResult result) {
  count_points({}, result);
  return result.points;
}

TEST(so_far, nothing_is_said_before_the_promises_are_settled) {
  Judged judged = example();
  judged.result.promises[1].held = false;
  judged.result.promises[1].failures.resize(2);
  for (const results::State state : {results::State::pass, results::State::fail,
                                     results::State::crash, results::State::blocked}) {
    judged.result.state = state;
    const results::TaskResult result = so_far(judged);
    EXPECT_EQ(result.state, results::State::not_judged);
    EXPECT_EQ(points(result), 0);
    ASSERT_EQ(result.promises.size(), 2U);
    EXPECT_TRUE(result.promises[1].failures.empty());
    EXPECT_EQ(result.reason, "right by itself; not judged with your other tasks yet");
  }
  judged.right_alone = false;
  EXPECT_EQ(so_far(judged).reason, "");
}

TEST(so_far, a_task_passes_with_its_last_picture) {
  Judged judged = example();
  judged.settled = true;
  EXPECT_EQ(so_far(judged).state, results::State::not_judged);
  EXPECT_EQ(points(so_far(judged)), 2);
  judged.result.pictures[1].state = results::State::pass;
  EXPECT_EQ(so_far(judged).state, results::State::not_judged);
  EXPECT_EQ(points(so_far(judged)), 3);
  judged.result.pictures[0].state = results::State::pass;
  EXPECT_EQ(so_far(judged).state, results::State::pass);
  EXPECT_EQ(points(so_far(judged)), 4);
}

TEST(so_far, a_task_waits_only_after_its_last_picture) {
  Judged judged = example();
  judged.settled = true;
  judged.result.state = results::State::blocked;
  EXPECT_EQ(so_far(judged).state, results::State::not_judged);
  for (results::PictureResult& picture : judged.result.pictures)
    picture.state = results::State::pass;
  EXPECT_EQ(so_far(judged).state, results::State::blocked);
}

TEST(so_far, a_fault_is_said_at_once) {
  Judged judged = example();
  judged.settled = true;
  for (const results::State state : {results::State::too_noisy, results::State::fail,
                                     results::State::timeout, results::State::crash}) {
    judged.result.pictures[0].state = state;
    EXPECT_EQ(so_far(judged).state, state);
  }
  judged.result.pictures[0].state = results::State::pass;
  for (const results::State state :
       {results::State::fail, results::State::rejected, results::State::not_attempted}) {
    judged.result.state = state;
    EXPECT_EQ(so_far(judged).state, state);
  }
}

TEST(so_far, of_two_pictures_the_worse_counts) {
  Judged judged = example();
  judged.settled = true;
  judged.result.pictures[0].state = results::State::too_noisy;
  judged.result.pictures[1].state = results::State::fail;
  EXPECT_EQ(so_far(judged).state, results::State::fail);
  std::swap(judged.result.pictures[0].state, judged.result.pictures[1].state);
  EXPECT_EQ(so_far(judged).state, results::State::fail);
}

using Slugs = std::vector<std::string>;

TEST(words, mean_a_task_an_exercise_or_a_part) {
  build::Config config;
  config.tasks = {{"1_rays", "1.1", "estimate_pixel", "", {}},
                  {"1_rays", "1.3", "hit_triangle", "", {}},
                  {"2_bvh", "2.1", "build_bvh", "", {}}};
  EXPECT_EQ(tasks_meant(config, "hit_triangle"), Slugs{"hit_triangle"});
  EXPECT_EQ(tasks_meant(config, "1.3"), Slugs{"hit_triangle"});
  EXPECT_EQ(tasks_meant(config, "1"), (Slugs{"estimate_pixel", "hit_triangle"}));
  EXPECT_EQ(tasks_meant(config, "1_rays"), (Slugs{"estimate_pixel", "hit_triangle"}));
  EXPECT_EQ(tasks_meant(config, "2"), Slugs{"build_bvh"});
  for (const char* nothing : {"", "3", "1.2", "hit", "rays"}) {
    EXPECT_THROW(tasks_meant(config, nothing), pt::Error) << nothing;
  }
}

// A named person has handed in a learner's folder, which the command finds without help.
TEST(words, judge_a_task_again) {
  GradeRequest request;
  request.seed = 7;
  request.submission = "student";
  EXPECT_EQ(replay_command(request, "hit_box"), "./run grade hit_box --seed 7");
  request.submission = "/class/ada";
  EXPECT_EQ(replay_command(request, "hit_box"),
            "./run grade hit_box --seed 7 --submission /class/ada");
  request.name = "ada";
  EXPECT_EQ(replay_command(request, "hit_box"), "./run grade hit_box --seed 7");
}

TEST(so_far, hides_where_the_judge_works) {
  results::TaskResult task;
  task.printed = "/folders/judge/cache/a.worker: /folders/judge/cache/a.worker: CPU ISA level";
  results::PromiseResult& promise = task.promises.emplace_back();
  promise.failures.emplace_back().got = "it died: /folders/judge/x /folders/judgement";
  results::PictureResult& picture = task.pictures.emplace_back();
  picture.text = "/folders/judge/a.worker";
  picture.render = "/folders/judge/a.exr";
  task = without_folder(task, "/folders/judge");
  EXPECT_EQ(task.printed, "cache/a.worker: cache/a.worker: CPU ISA level");
  EXPECT_EQ(task.promises[0].failures[0].got, "it died: x /folders/judgement");
  EXPECT_EQ(task.pictures[0].text, "a.worker");
  EXPECT_EQ(task.pictures[0].render, "/folders/judge/a.exr");
}

}  // namespace
}  // namespace grader::judging
