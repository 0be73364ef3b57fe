#pragma once

#include "grader/results/results.h"

#include <cstddef>
#include <string>
#include <vector>

// Sentences that all writers share.

namespace grader::results {

// The state in words: "not attempted".
std::string words(State state);

// A character that stands for the state next to the words.
const char* symbol(State state);

// Returns whether the submission is at fault: not if it is right, not written, or waits for another
// task.
bool is_fault(State state);

struct Totals {
  int points = 0;
  int max_points = 0;
  int bonus_points = 0;
  int passed = 0;      // tasks
  int not_judged = 0;  // tasks
};
Totals totals(const std::vector<TaskResult>& tasks);

// Returns whether there is a verdict on a promise of the task. During the run, the promises of a
// task get their verdicts at the same time.
bool is_judged(const TaskResult& task, const PromiseResult& promise);

// The number of promises and pictures, and of those among them that have a verdict.
struct Counts {
  std::size_t all = 0, judged = 0;
};
Counts verdicts(const Results& results);

// "7 of 12 tasks pass", "2 of 12 tasks pass, 9 not judged yet"
std::string passed(const Results& results);

// "7 of 12 tasks pass. 61 of 97 points and 2 bonus."
std::string verdict(const Results& results);

// The sentence in the report of an unfinished run.
inline constexpr const char* kStopped =
    "This run was stopped before it ended: what is not judged yet has no points.";

// "27.0 s (properties 5.9 s, pictures 21.0 s)"
std::string times(const Results& results);

// "Firstlight 1.0.0", as `./run --version` prints it; empty in the results of an older grader.
std::string version(const Results& results);

// The time of the task's promises and pictures together.
double seconds(const TaskResult& task);

// "1" and "rays" of "1_rays".
std::string part_number(const std::string& part);
std::string part_name(const std::string& part);

// "This is a known mistake", or that it is one of several. Empty if none is named.
std::string mistake_kind(const TaskResult& task);

// "This is a known mistake: Compares t with zero where it should be t_min. Hint: ..." Empty if none
// is named.
std::string mistake_text(const TaskResult& task);

// "One cause: 9 promises fail, 6 points are taken." Without a name of the mistake, "One reason counts once: ...". Empty if nothing is
// spared.
std::string spared_text(const TaskResult& task);

// The bonus promises that the task does not keep, although it keeps all others.
std::vector<const PromiseResult*> missed_bonus(const TaskResult& task);

// "without the bonus: leaves no gap at shared edges". Empty if none is missed.
std::string missed_bonus_text(const TaskResult& task);

// The command that writes a page with the picture.
std::string how_to_see(const TaskResult& task, const PictureResult& picture);

// The command that shows the picture in the view, and the paths of a pixel where it fails.
std::string how_to_look(const std::string& slug, const PictureResult& picture);

// The same for the first picture of the task with a place that fails. Empty if there is none.
std::string how_to_look(const TaskResult& task);

}  // namespace grader::results
