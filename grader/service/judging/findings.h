#pragma once

#include "grader/results/results.h"
#include "grader/service/build/builder.h"
#include "grader/service/judging/grade.h"
#include "grader/service/process/run_command.h"

#include <atomic>
#include <string>
#include <utility>
#include <vector>

namespace grader::judging {

struct Trial {
  const build::TaskConfig& task;
  const build::Built& worker;
  bool integrated = false;
  const GradeRequest& request;
  std::vector<std::string> promises;        // only these; all if empty
  const std::atomic<bool>* stop = nullptr;  // once true, makes try_worker throw process::Stopped
};

// Runs the property program, unless the cache has its result, and returns its findings
// (grader/programs/graded.cpp). If the answers make the program itself die or take too long, there
// are no promises, and a reason. Safe from any thread. Throws pt::Error if the program cannot judge.
results::TaskResult try_worker(const build::Builder& builder, const Trial& trial);

// The state of a task whose answers made a program of the judge die or take too long, and the reason.
// This is that task's fault, or ours: the other tasks still get their verdicts.
std::pair<results::State, std::string> ended_by_answers(const process::CommandResult& ended);

}  // namespace grader::judging
