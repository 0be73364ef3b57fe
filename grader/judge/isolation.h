#pragma once

#include "grader/judge/findings.h"
#include "grader/judge/grade.h"

namespace grader {

// A task on its way to a verdict.
struct Judged {
  const TaskConfig* config = nullptr;
  Built object;  // of the submission's file, if it compiles
  TaskResult result;
};

// Judges each task by itself: the submission's task, the judge's answers or the reference in all
// other places. Leaves a state for each; what passes here is right by itself.
void judge_alone(const Config& config, const Builder& builder, const GradeRequest& request,
                 std::vector<Judged>& judged);

// Puts findings into a result: the state, and every failure with the command that replays it.
void enter(const Findings& findings, const GradeRequest& request, TaskResult& result);

// Points from promises.
void count_points(TaskResult& result);

}  // namespace grader
