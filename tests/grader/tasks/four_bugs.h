#pragma once

#include "tests/fixtures/hostile_submission.h"
#include "tests/fixtures/task_folder.h"

#include <array>
#include <string>

// Four bugs from a write-up of the course, which its author found by looking at pictures.
// docs/four_bugs.md shows our report on each.

namespace grader::tests {

struct Bug {
  const char* title;
  const char* task;
  const char* mistake;  // in grader/tasks/<task>/mistakes.txt
  const char* promise;  // the promise that it breaks
  const char* recipe;   // the recipe that shows it well
};

inline constexpr std::array<Bug, 4> kFourBugs{{
    {"The box test overwrites the ray's range", "hit_bvh", "range_overwritten",
     "finds_the_nearest_hit", "bvh_coil"},
    {"Children joined by a short-circuit", "hit_bvh", "first_child_that_hits",
     "finds_the_nearest_hit", "bvh_coil"},
    {"The BSDF applied twice", "trace_path", "bsdf_applied_twice", "matches_the_furnace",
     "global_indirect"},
    {"The running total taken for the sample", "adaptive_pixel", "running_total_as_the_sample",
     "stops_where_the_interval_is_narrow", "adaptive_fine"},
}};

// The reference with this bug.
inline void put(const Bug& bug, const Submission& submission) {
  submission.replace(bug.task, kept_solution(FIRSTLIGHT_ROOT, bug.task, "wrong", bug.mistake).file);
}

}  // namespace grader::tests
