#pragma once

#include "grader/judge/builder.h"
#include "grader/judge/grade.h"
#include "grader/results/results.h"

#include <string>
#include <vector>

namespace grader::judge {

// The findings of a property program about one task on one worker (grader/programs/graded_report.h).
struct Findings {
  results::TaskResult task;
  std::string broken;  // why there are no findings; empty if there are
};

struct Trial {
  const TaskConfig& task;
  const Built& worker;
  bool integrated = false;
  const GradeRequest& request;
  std::vector<std::string> promises;  // only these; all if empty
};

// Runs the property program, unless the same was run before. Safe from any thread.
Findings try_worker(const Builder& builder, const Trial& trial);

}  // namespace grader::judge
