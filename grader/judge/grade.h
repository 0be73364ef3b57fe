#pragma once

#include "grader/judge/config.h"
#include "grader/process/time_limit.h"
#include "grader/results/results.h"
#include "grader/sandbox/probe.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace grader::judge {

struct GradeRequest {
  std::string submission;          // a folder with the tree of student/
  std::vector<std::string> asked;  // slugs
  std::uint64_t seed = 1;
  int call_limit = static_cast<int>(process::kCallLimit.count());  // milliseconds
  int threads = 2;
  bool pictures = true;            // rendered and judged too, not the promises only
  std::string command;             // the command line, for the report
  sandbox::Isolation isolation{};  // of all that runs of the submission
  int compile_limit = 60;          // seconds that a file may take
  std::string name{};              // who handed it in; empty: it is called by its folder
};

// The folder that reports name: that of the submission, or student/ if the submission has a name.
std::string shown_folder(const GradeRequest& request);

// "./run grade hit_box --seed 7": how a learner, or who has the folder, sees it again.
std::string replay_command(const GradeRequest& request, const std::string& slug);

// The slugs of the tasks that are judged: those asked for, and all that they need.
std::vector<std::string> tasks_judged(const Config& config, const std::vector<std::string>& asked);

// Judges the tasks asked for, each by itself and then together with the submission's other tasks.
// `progress` gets the results so far: at first without a verdict, then after every verdict.
results::Results grade(const Config& config, const GradeRequest& request,
                       const std::function<void(const results::Results&)>& progress);

// The slugs that a word means: a task, a part ("1", "1_rays"), or an exercise ("1.3"). Throws
// pt::Error if there is none.
std::vector<std::string> tasks_meant(const Config& config, const std::string& word);

}  // namespace grader::judge
