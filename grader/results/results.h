#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// The findings of a grading run: the one model that the judge fills and every writer reads. No
// writer decides anything. docs/results.md describes its JSON.

namespace grader::results {

inline constexpr int kSchemaVersion = 2;

enum class State {
  pass,
  fail,
  crash,          // the process died, or the task threw
  timeout,        // no answer within the limit
  not_attempted,  // the task calls todo(), or its file is missing
  blocked,        // right by itself; waits for another task of the submission, which fails
  too_noisy,      // a picture that is right on average, but has too much noise
  rejected,       // the file is not one that the judge accepts
  not_judged,     // not yet: only in the results of a run that has not ended
};

inline constexpr std::array kStates{State::pass,      State::fail,          State::crash,
                                    State::timeout,   State::not_attempted, State::blocked,
                                    State::too_noisy, State::rejected,      State::not_judged};

// "pass", "not_attempted": as it stands in JSON.
const char* name(State state);

// The reason why a case failed. All except the first mean that the call itself failed; they are known
// only if the task runs in another process.
enum class Cause {
  wrong,          // the answer is not what was promised
  crash,          // the process died, or the task threw
  timeout,        // no answer within the limit
  bad_reply,      // an answer that no implementation of the contract can give
  not_attempted,  // the task calls todo()
  not_called,     // other calls failed, so that no more were made
};

inline constexpr std::array kCauses{Cause::wrong,     Cause::crash,         Cause::timeout,
                                    Cause::bad_reply, Cause::not_attempted, Cause::not_called};

// "wrong", "bad reply": as it stands in JSON, and for people.
const char* name(Cause cause);

// A promise that was not kept, on the smallest input found. All texts are for a person to read.
struct Failure {
  std::vector<std::string> input{};  // a line per value
  std::string what{};                // the thing compared; may be empty
  std::string got{};
  std::string expected{};
  std::string off_by{};  // empty if there is no number
  Cause cause = Cause::wrong;
  bool statistical = false;  // an estimate was off by more than chance allows
  int cases_before = 0;      // the number of cases that held first
  bool simple = false;       // an input of simple values fails, too, and is shown
  std::uint64_t seed = 0;    // of the run
  bool integrated = false;   // found with the submission's other tasks, not by itself
  std::string replay{};      // the command that shows it again

  bool operator==(const Failure&) const = default;
};

struct PromiseResult {
  std::string name;   // "keeps_t_inside_the_ray": the property's
  std::string words;  // "keeps t inside the ray: no hit before t_min, ...": the contract's
  bool bonus = false;
  bool held = false;
  int points = 1;  // for keeping it
  double seconds = 0;
  std::vector<Failure> failures;
  int checks = 0;       // the number of things that it checks; 0: not known
  double likeness = 0;  // to known mistakes that break it, from 0 to 1 (grader/mistakes/naming.h)

  bool operator==(const PromiseResult&) const = default;
};

// A part of a picture that is wrong, in pixels from the top left.
struct FailingCell {
  int x = 0, y = 0, width = 0, height = 0;
  std::string channel;  // "Y" (luminance), "R", "G" or "B"
  double off_by = 0;    // relative to the golden: -0.094 is 9.4 % too dark
  double evidence = 0;  // |z| over its threshold, of the last round

  bool operator==(const FailingCell&) const = default;
};

// A recipe rendered with the submission, and the verdict on it. The files are EXRs (pt/image) that
// the judge made: they stay in its cache, next to it on the same machine.
struct PictureResult {
  std::string recipe;  // its name in scenes/recipes.json
  std::string title;   // what it shows, in words
  State state = State::not_judged;
  std::string text;         // one sentence; empty if it passes
  bool integrated = false;  // rendered with all tasks of the submission; else with this one only
  int samples = 0;          // per pixel, of all rounds together
  int rounds = 0;           // number rendered; more than one if the first found a failing cell
  double noise = 0;         // variance of the submission's samples over the golden's
  double seconds = 0;
  int points = 0;
  int max_points = 0;
  std::string replay;  // the command that shows it again
  int width = 0;
  int height = 0;
  std::string golden;         // a path, like the next four; mean and variance
  std::string render;         // the same of the submission; empty if there is no picture
  std::string evidence;       // R: the largest |z| / threshold of the cells that hold the pixel
  std::string golden_counts;  // of an adaptive recipe: samples per pixel, written by write_counts
  std::string counts;         // the same of the submission
  std::vector<FailingCell> cells;  // the smallest failing cells

  bool operator==(const PictureResult&) const = default;
};

// A mistake that alone explains all that is wrong with a task. If nothing is certain, there is
// none.
struct Mistake {
  std::string name;              // of grader/tasks/<slug>/mistakes.txt; several are joined by ", "
  std::string sentence;          // says what is wrong
  std::string found_by;          // "battery": by the task's answers
  std::string hint{};            // leads to the line
  bool always_the_same = false;  // every call gets the same answer: nothing is computed

  bool empty() const { return name.empty(); }
  bool operator==(const Mistake&) const = default;
};

struct TaskResult {
  std::string part;    // "1_rays"
  std::string number;  // "1.3"
  std::string slug;
  std::string called;  // the name of the function in the learner's own code; empty: the slug
  State state = State::not_judged;
  std::string reason;  // one sentence if the promises do not say why: blocked, rejected, ...
  int points = 0;      // for promises kept and pictures that are right
  int max_points = 0;  // of the pictures, and of all promises but bonus ones
  int bonus_points = 0;
  int spared = 0;  // the part of `points` that is given back: one cause costs a part of them
  Mistake mistake;
  std::vector<std::string> blocked_by;  // slugs of the tasks that it waits for
  std::vector<std::string> blamed;      // slugs: it would pass with the reference for any of them
  std::string compiler_output;
  std::string warnings;      // of the compiler, about a file that compiles
  bool keeps_state = false;  // a variable keeps its value between calls, which costs points
  std::string printed;       // the beginning of what the task printed while it was judged
  std::vector<PromiseResult> promises;
  std::vector<PictureResult> pictures;

  bool operator==(const TaskResult&) const = default;
};

// A part of the run that has ended, and its time: "compiling", "properties", "pictures".
struct Phase {
  std::string name;
  double seconds = 0;

  bool operator==(const Phase&) const = default;
};

struct Results {
  std::string submission;  // the folder
  std::uint64_t seed = 0;
  std::string isolation;              // the tier, "C: rlimits only, not isolated"
  std::vector<std::string> versions;  // what it was judged with: "Firstlight 1.0.0", "GNU 12.2.0"
  std::string command;                // reproduces the run
  std::string dialect;  // what is judged, in the words of a course; empty: the contracts
  double seconds = 0;
  std::vector<Phase> phases;
  bool complete = false;           // false in a file that a killed run left
  std::vector<std::string> asked;  // slugs
  std::vector<TaskResult> tasks;   // in the order of the course

  bool operator==(const Results&) const = default;
};

// The state of a task by its promises, and by whether it keeps state. Bonus promises decide nothing.
State state_of(const TaskResult& task);

// Returns whether all that was asked for passes.
bool passes(const Results& results);

}  // namespace grader::results
