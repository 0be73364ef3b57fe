#pragma once

#include "grader/results/results.h"

#include <map>
#include <string>

namespace grader::results {

// The worth of the promises and pictures of one task.
struct TaskPoints {
  int promise = 1;
  int picture = 1;
  int too_noisy = 0;                    // for a picture that is right on average
  int keeps_state = 0;                  // the cost of a variable that keeps its value
  double one_cause = 1;                 // the share of the promises' points that one cause may take
  int examples = 0;                     // the bonus for each row of examples (kExamples)
  std::map<std::string, int> promises;  // by name: promises with other points
  std::map<std::string, int> pictures;  // by recipe
};

using Points = std::map<std::string, TaskPoints>;  // by slug

// The names of promises that a learner's examples keep, not the task, begin with this. They are bonus promises: the examples catch all
// ordinary mistakes that break the promise whose name follows.
inline constexpr const char* kExamples = "examples:";

// Mistake::found_by of a mistake that costs no more than one promise: a dialect says so.
inline constexpr const char* kOneCause = "one cause";
// And of one that has a name only: the submission may have named it itself.
inline constexpr const char* kNamedOnly = "named";

// Reads grader/points.json:
//   {"parts": {part: n},
//    "default": {"promise": n, "picture": n, "too_noisy": n, "keeps_state": n,
//                "one_cause": share, "examples": n},
//    "tasks": {slug: {as above, "promises": {name: n}, "pictures": {recipe: n}}}}
// A task that "tasks" does not name has the points of the default; one that is not in the table of
// tasks is refused.
// All points of a part ("4_global") are multiplied by its number in "parts", if it has one; 0: the
// course leaves it out. Throws pt::Error, with the file and what to do, for anything else.
Points load_points(const std::string& path);

// Returns whether the task earns no points at all, for example in a part that the course leaves out.
bool is_left_out(const Points& points, const std::string& slug);

// Returns whether the promise holds, at least with the reference in place of the other tasks.
bool is_kept_by_itself(const PromiseResult& promise);

// Fills in the points of each promise and picture, and the sums. What is right with the reference
// elsewhere, and wrong only with the submission's other tasks, keeps its points: the mistake is
// theirs, and counts there. A picture earns at most the share of its points that the promises of its
// task earn of theirs, rounded. If a mistake is named, it is the one cause of all that is wrong: then
// broken promises together cost at most the share `one_cause` of the points of the task's promises,
// rounded up to a whole point. Promises that are broken for the same reason (the same end of a call, as a crash, or the same answer to
// the same input) count once, unless `one_cause` is 1. Anything beyond that is given back as `spared`: at most what the
// promises that hold earn, and nothing if the task always gives the same answer. If kOneCause found
// it, they cost what the dearest of them is worth; if kNamedOnly did, all that they are worth.
void count_points(const Points& points, TaskResult& result);

}  // namespace grader::results
