#pragma once

#include <cstdint>
#include <string>
#include <vector>

// What a grading run found: the one model that the judge fills and every writer reads. No writer
// decides anything. docs/results.md describes its JSON.

namespace grader {

inline constexpr int kSchemaVersion = 1;

enum class State {
  pass,
  fail,
  crash,          // the process died, or the task threw
  timeout,        // no answer within the limit
  not_attempted,  // the task calls todo(), or its file is missing
  blocked,        // right by itself; not judged with the submission's other tasks, as one fails
  too_noisy,      // of a picture: too few samples to decide
  rejected,       // the file is not one that the judge accepts
};

// "pass", "not_attempted": as it stands in JSON.
const char* name(State state);

// A promise that was not kept, on the smallest input found. All texts are for a person to read.
struct FailureReport {
  std::vector<std::string> input;  // a line a value
  std::string what;                // what was compared; may be empty
  std::string got;
  std::string expected;
  std::string off_by;  // empty where there is no number
  std::string cause;   // "wrong", "crash", "timeout", "bad reply", "not attempted"
  int cases_before = 0;
  std::uint64_t seed = 0;
  bool integrated = false;  // found with the submission's other tasks, not by itself
  std::string replay;       // the command that shows it again
};

struct PromiseResult {
  std::string name;   // "keeps_t_inside_the_ray": the property's
  std::string words;  // "keeps t inside the ray: no hit before t_min, ...": the contract's
  bool bonus = false;
  bool held = false;
  double seconds = 0;
  std::vector<FailureReport> failures;
};

// A rendered picture and its verdict. Nothing fills these yet.
struct PictureResult {
  std::string recipe;
  State state = State::not_attempted;
  std::string text;
};

struct TaskResult {
  std::string part;    // "1_rays"
  std::string number;  // "1.3"
  std::string slug;
  State state = State::not_attempted;
  std::string reason;  // one sentence where the promises do not say it: why blocked, rejected, ...
  int points = 0;      // one for each promise kept
  int max_points = 0;  // of the promises that are no bonus
  int bonus_points = 0;
  std::vector<std::string> blocked_by;  // slugs: why it was not judged with the submission's others
  std::vector<std::string> blamed;      // slugs: with the reference in their place it would pass
  std::string compiler_output;
  std::string printed;  // the beginning of what the task printed while it was judged
  std::vector<PromiseResult> promises;
  std::vector<PictureResult> pictures;
};

struct Results {
  std::string submission;  // the folder
  std::uint64_t seed = 0;
  std::string isolation;  // the tier, "C: rlimits only, not isolated"
  double seconds = 0;
  bool complete = false;           // false in a file that a killed run left
  std::vector<std::string> asked;  // slugs
  std::vector<TaskResult> tasks;   // in the order of the course
};

// Whether all that was asked for passes.
bool passes(const Results& results);

}  // namespace grader
