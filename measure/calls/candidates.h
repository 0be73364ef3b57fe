#pragma once

#include "grader/service/build/builder.h"
#include "measure/calls/options.h"
#include "measure/calls/tasks.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace measure::calls {

// An implementation of a task, with its workers, whose other tasks are the reference's.
struct Candidate {
  std::string name;     // "reference", "half_b", or the label of a submission
  std::string own;      // the folder of a user's own code; all others are known to be right
  std::string problem;  // why it cannot be measured, one sentence; else empty
  std::string plain;    // a program, for measuring time
  std::string counted;  // a program that counts boxes; empty: no boxes are tested

  bool is_own() const { return !own.empty(); }
};

// A task and its candidates, the reference first.
struct Contest {
  const About* about = nullptr;  // of tasks()
  std::vector<Candidate> candidates;
};

// The settings for building workers.
struct Materials {
  grader::build::Config config;
  std::map<std::string, grader::build::Paths> fast;  // see measure/renders/worker_config.h
  grader::sandbox::Tier tier = grader::sandbox::Tier::limits;
};

// The requested tasks with their candidates, compiled and linked in boxes; a candidate for which
// that fails has the reason. Throws pt::Error for unknown words. `progress` gets the part done.
std::vector<Contest> find_contests(const Materials& materials, const Options& options,
                                   const std::function<void(double)>& progress);

}  // namespace measure::calls
