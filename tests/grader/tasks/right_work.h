#pragma once

#include "grader/service/judging/grade.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

// Right work as a class hands it in: the reference, each right variant with the reference's other
// tasks, mixtures of variants for all twelve tasks, and whole submissions in different styles
// (tests/fixtures/right). The program right_work grades as many of them as its caller wants; the
// judge must never fail any of them.

namespace grader::tests {

// One submission and how it is graded.
struct RightJob {
  std::string kind;                          // "mixture", "variant", "reference" or "whole"
  std::string name;                          // "17", "hit_sphere.half_b", "reference", "plain"
  std::map<std::string, std::string> files;  // path of each task's file by slug
  std::vector<std::string> asked;            // the slugs that are judged
  std::uint64_t seed = 1;
  bool pictures = false;
};

// The candidate files for each task, in alphabetical order: the reference's file, then the files in
// grader/tasks/<slug>/right.
using Choices = std::map<std::string, std::vector<std::filesystem::path>>;
Choices right_choices(const build::Config& config);

// The reference, each variant alone, each whole submission, and the mixture of this number, in
// which all files of a task are equally likely. A number means the same mixture until a file is
// added.
RightJob reference_job(const Choices& choices, std::uint64_t seed);
std::vector<RightJob> variant_jobs(const Choices& choices, std::uint64_t seed);
std::vector<RightJob> whole_jobs(const build::Config& config, std::uint64_t seed);
RightJob mixture_job(const Choices& choices, int number);

// A graded submission. `judge` is a hash of the job's files and of the judging programs: a verdict
// is valid only while the hash stays the same.
struct RightRow {
  std::string kind, name;
  std::uint64_t seed = 1;
  bool pictures = false;
  int busy = 0;  // endless loops that ran at the same time
  std::string judge;
  bool passed = false;
  double seconds = 0;
  std::string faults;  // "hit_bvh: fail, says_which_primitive; ..."; empty if it passed

  // Returns a key that is different for every row.
  std::string key() const;
};

RightRow row_of(const build::Config& config, const RightJob& job, int busy);

// A line of a CSV, without its end; and the complete lines of a file, none if there is no file.
// Throws pt::Error for a line that is not a row.
std::string to_line(const RightRow& row);
std::vector<RightRow> read_right_rows(const std::filesystem::path& path);

// Grades the job in a temporary folder below config.work.
RightRow grade_right(const build::Config& config, const sandbox::Isolation& isolation,
                     const RightJob& job, int busy);

}  // namespace grader::tests
