#pragma once

#include "grader/door/dialect.h"
#include "grader/results/results.h"
#include "grader/service/build/config.h"
#include "grader/service/process/time_limit.h"
#include "grader/service/sandbox/probe.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace grader::judging {

struct GradeRequest {
  std::string submission;          // a folder with the tree of student/
  std::string shown{};             // the folder that reports show; empty: that one
  std::string note{};              // which of several files are in it; may be empty
  std::string refused{};           // the reason why nothing in it can be judged; else empty
  std::vector<std::string> asked;  // slugs
  std::uint64_t seed = 1;
  int call_limit = static_cast<int>(process::kCallLimit.count());  // milliseconds
  int threads = 2;
  bool pictures = true;                    // judge pictures too, not only promises
  std::string command;                     // the command line, for the report
  sandbox::Isolation isolation{};          // for all code of the submission
  int compile_limit = 60;                  // seconds per file
  std::string name{};                      // of the learner; empty: reports use the folder
  std::optional<door::Dialect> dialect{};  // of the course in whose skeleton the work is
};

// The folder that reports show: the submission's, or student/ if the submission has a name.
std::string shown_folder(const GradeRequest& request);

// "./run grade hit_box --seed 7": the command with which anybody who has the folder sees it again.
std::string replay_command(const GradeRequest& request, const std::string& slug);

// The slugs of the tasks to judge: the requested tasks, and all that they need.
std::vector<std::string> tasks_judged(const build::Config& config,
                                      const std::vector<std::string>& asked);

// Judges the requested tasks, each alone and then together with the submission's other tasks.
// `progress` gets the results so far: first without a verdict, then after every verdict.
results::Results grade(const build::Config& config, const GradeRequest& request,
                       const std::function<void(const results::Results&)>& progress);

// Throws pt::Error if grader/points.json cannot be used or names what does not exist, or if a golden has
// been exchanged.
void check_points_and_goldens(const build::Config& config);

// The slugs that a word means: a task, a part ("1", "1_rays"), or an exercise ("1.3"). Throws
// pt::Error if there is none.
std::vector<std::string> tasks_meant(const build::Config& config, const std::string& word);

}  // namespace grader::judging
