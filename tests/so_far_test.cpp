// What a report says of a task whose run has not ended.
#include "grader/judge/so_far.h"

#include "grader/judge/points.h"

#include <gtest/gtest.h>

namespace grader {
namespace {

// Right by itself, with two promises kept and two pictures to come.
Judged example() {
  Judged judged;
  judged.result.slug = "trace_path";
  judged.result.state = State::pass;
  judged.right_alone = true;
  for (const char* name : {"a", "b"}) {
    judged.result.promises.push_back({name, "words", false, true, 1, 0, {}});
    judged.result.pictures.emplace_back().recipe = name;
  }
  return judged;
}

int points(TaskResult result) {
  count_points({}, result);
  return result.points;
}

TEST(so_far, nothing_is_said_before_the_promises_are_settled) {
  Judged judged = example();
  judged.result.promises[1].held = false;
  judged.result.promises[1].failures.resize(2);
  for (const State state : {State::pass, State::fail, State::crash, State::blocked}) {
    judged.result.state = state;
    const TaskResult result = so_far(judged);
    EXPECT_EQ(result.state, State::not_judged);
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
  EXPECT_EQ(so_far(judged).state, State::not_judged);
  EXPECT_EQ(points(so_far(judged)), 2);
  judged.result.pictures[1].state = State::pass;
  EXPECT_EQ(so_far(judged).state, State::not_judged);
  EXPECT_EQ(points(so_far(judged)), 3);
  judged.result.pictures[0].state = State::pass;
  EXPECT_EQ(so_far(judged).state, State::pass);
  EXPECT_EQ(points(so_far(judged)), 4);
}

TEST(so_far, a_task_waits_only_after_its_last_picture) {
  Judged judged = example();
  judged.settled = true;
  judged.result.state = State::blocked;
  EXPECT_EQ(so_far(judged).state, State::not_judged);
  for (PictureResult& picture : judged.result.pictures) picture.state = State::pass;
  EXPECT_EQ(so_far(judged).state, State::blocked);
}

TEST(so_far, a_fault_is_said_at_once) {
  Judged judged = example();
  judged.settled = true;
  for (const State state : {State::too_noisy, State::fail, State::timeout, State::crash}) {
    judged.result.pictures[0].state = state;
    EXPECT_EQ(so_far(judged).state, state);
  }
  judged.result.pictures[0].state = State::pass;
  for (const State state : {State::fail, State::rejected, State::not_attempted}) {
    judged.result.state = state;
    EXPECT_EQ(so_far(judged).state, state);
  }
}

TEST(so_far, of_two_pictures_the_worse_counts) {
  Judged judged = example();
  judged.settled = true;
  judged.result.pictures[0].state = State::too_noisy;
  judged.result.pictures[1].state = State::fail;
  EXPECT_EQ(so_far(judged).state, State::fail);
  std::swap(judged.result.pictures[0].state, judged.result.pictures[1].state);
  EXPECT_EQ(so_far(judged).state, State::fail);
}

}  // namespace
}  // namespace grader
