#pragma once

#include "grader/judge/builder.h"
#include "grader/judge/grade.h"
#include "grader/results/results.h"

#include <optional>
#include <set>
#include <string>

namespace grader::judge {

// The findings of a property program about one task on one worker.
struct Findings {
  std::vector<results::PromiseResult> promises;  // name, held, seconds and failures are filled
  std::set<std::string> todo;                    // slugs of tasks that are not written
  std::string printed;
  std::string kept;  // the name of a variable that the task keeps between calls; may be empty
};

struct Trial {
  const TaskConfig& task;
  const Built& worker;
  bool integrated = false;
  const GradeRequest& request;
  std::vector<std::string> promises;  // only these; all if empty
};

// Runs the property program, unless the same was run before. Safe from any thread. Throws pt::Error
// if that program cannot judge.
Findings try_worker(const Builder& builder, const Trial& trial);

}  // namespace grader::judge
