#pragma once

#include "grader/results/results.h"
#include "grader/service/build/builder.h"
#include "grader/service/judging/grade.h"

#include <stop_token>
#include <string>
#include <vector>

namespace grader::judging {

struct Trial {
  const build::TaskConfig& task;
  const build::Built& worker;
  bool integrated = false;
  const GradeRequest& request;
  std::vector<std::string> promises;  // only these; all if empty
  std::stop_token stop{};             // makes try_worker throw process::Stopped
};

// Runs the property program, unless the cache has its result, and returns its findings
// (grader/programs/write_report.h). Safe from any thread. Throws pt::Error if the program cannot
// judge.
results::TaskResult try_worker(const build::Builder& builder, const Trial& trial);

}  // namespace grader::judging
