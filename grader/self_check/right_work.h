#pragma once

#include "grader/judge/grade.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

// Right work, as a class hands it in: the reference, each right variant alone among the reference's
// other tasks, mixtures of variants in all twelve places, and whole submissions, each in a style of
// its own (grader/self_check/right). The program right_work grades as much of it as one likes,
// since the judge must never fail any of it.

namespace grader::self_check {

// One submission and how it is graded.
struct RightJob {
  std::string kind;                          // "mixture", "variant", "reference" or "whole"
  std::string name;                          // "17", "hit_sphere.half_b", "reference", "plain"
  std::map<std::string, std::string> files;  // slug -> path of its file, of all tasks
  std::vector<std::string> asked;            // the slugs that are judged
  std::uint64_t seed = 1;
  bool pictures = false;
};

// The files to choose from for each task, in alphabetical order: the reference's, then those in
// grader/tasks/<slug>/right.
using Choices = std::map<std::string, std::vector<std::filesystem::path>>;
Choices right_choices(const judge::Config& config);

// The reference, each variant alone, each whole submission, and the mixture of that number: every
// file equally likely in its place. The same number is the same mixture as long as no file is
// added.
RightJob reference_job(const Choices& choices, std::uint64_t seed);
std::vector<RightJob> variant_jobs(const Choices& choices, std::uint64_t seed);
std::vector<RightJob> whole_jobs(const judge::Config& config, std::uint64_t seed);
RightJob mixture_job(const Choices& choices, int number);

// A submission graded. `judge` is a hash of the job's files and of the programs that judged it: a
// verdict is known only as long as it is the same.
struct RightRow {
  std::string kind, name;
  std::uint64_t seed = 1;
  bool pictures = false;
  int busy = 0;  // endless loops that ran beside it
  std::string judge;
  bool passed = false;
  double seconds = 0;
  std::string faults;  // "hit_bvh: fail, says_which_primitive; ..."; empty if it passed

  // Tells it from all others.
  std::string key() const;
};

RightRow row_of(const judge::Config& config, const RightJob& job, int busy);

// One line of a CSV, without its end; and all whole lines of a file, none if there is no file.
// Throws pt::Error for a line that is not such a row.
std::string to_line(const RightRow& row);
std::vector<RightRow> read_right_rows(const std::filesystem::path& path);

// Grades the job in a folder of its own below config.work, which is gone afterwards.
RightRow grade_right(const judge::Config& config, const sandbox::Isolation& isolation,
                     const RightJob& job, int busy);

}  // namespace grader::self_check
