#pragma once

#include "grader/judge/builder.h"
#include "writeup/measure/options.h"
#include "writeup/measure/tasks.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace writeup::measure {

// One way to write a task, with the workers that run it: the reference is in all other places.
struct Candidate {
  std::string name;     // "reference", "half_b", or that of the folder that it came from
  bool is_own = false;  // somebody's own; all others are known to be right
  std::string problem;  // the reason why it cannot be measured, one sentence; empty: it can
  std::string plain;    // a program; its time is measured
  std::string counted;  // a second program, which counts boxes; empty: rays test none
};

// A task, the reference first.
struct Contest {
  const About* about = nullptr;  // of tasks()
  std::vector<Candidate> candidates;
};

// The materials to build workers of.
struct Materials {
  grader::judge::Config config;
  std::map<std::string, grader::judge::Paths> fast;  // as writeup/worker_config.h has them
  grader::sandbox::Tier tier = grader::sandbox::Tier::limits;
};

// The tasks that are asked for, each with its candidates, which are compiled and linked in boxes; a candidate
// for which that fails says why. Throws pt::Error for words that mean nothing. `progress` gets the part done.
std::vector<Contest> find_contests(const Materials& materials, const Options& options,
                                   const std::function<void(double)>& progress);

}  // namespace writeup::measure
