#pragma once

#include "grader/judge/builder.h"
#include "grader/judge/grade.h"
#include "grader/results/results.h"

#include <stop_token>
#include <string>
#include <vector>

namespace grader::judge {

struct Trial {
  const TaskConfig& task;
  const Built& worker;
  bool integrated = false;
  const GradeRequest& request;
  std::vector<std::string> promises;  // only these; all if empty
  std::stop_token stop{};             // asks try_worker to throw process::Stopped
};

// Runs the property program, unless the same was run before, and returns what it wrote
// (grader/programs/write_report.h). Safe from any thread. Throws pt::Error if that program cannot
// judge.
results::TaskResult try_worker(const Builder& builder, const Trial& trial);

}  // namespace grader::judge
