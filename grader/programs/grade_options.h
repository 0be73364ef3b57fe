#pragma once

#include "grader/report/write_reports.h"
#include "grader/service/process/time_limit.h"

#include <cstdint>
#include <string>
#include <vector>

namespace grader::programs {

// The options of `grade`.
struct GradeOptions {
  std::vector<std::string> what;
  std::string submission = "student";
  bool is_named = false;  // on the command line
  std::string note;       // which of the files handed in are in the folder; of a class
  std::string course;     // the files are made of a clone of the course since this year; of a class
  std::string name;       // of the learner who handed it in
  report::ReportFiles files;
  std::string from_results;
  std::string config;
  std::string work;  // the folder for its builds; empty: the one of the config
  std::uint64_t seed = 1;
  int call_limit = static_cast<int>(process::kCallLimit.count());
  int compile_limit = 60;
  int threads = 2;
  std::string isolation;
  std::string dialect = "course";  // of work in the skeleton of a course; none: by our contracts
  bool require_isolation = false;
  bool all = false;
  bool no_pictures = false;
  bool quiet = false;
  std::string take_to;    // only writes the task files to this folder
  bool programs = false;  // only names the programs that judge what is asked for
  bool resume = false;    // continues the interrupted run; all other options then come from it
};

// The command that a person would type for the same verdicts.
std::string command(const GradeOptions& options);

// Reads the words after the program's name. Prints help and exits for --help; throws pt::Error for what it cannot use.
GradeOptions parse_options(const std::vector<std::string>& words);

}  // namespace grader::programs
