#pragma once

#include "grader/results/results.h"
#include "grader/service/build/config.h"
#include "grader/service/intake/handed_in.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

// One submission of a class, with its reports in a folder:
//   <name>.json, <name>.html   the reports
//   <name>.key                 a hash of all that they depend on; written last
//   <name>.problem             the plan's ID, and why it was not judged. If its files
//                              changed meanwhile, there is none: it is judged again

namespace grader::classes {

// The settings with which everybody in the class is judged.
struct Judging {
  const build::Config& config;
  std::string grade;     // the program
  std::string out;       // the folder of the reports
  std::string plan;      // the ID of the plan in it
  std::string former{};  // the folder of an earlier grading, whose results may be used again
  std::map<std::string, std::string> former_names{};  // current name -> earlier name
  std::vector<std::string> words{};                   // options for the program's command line
  std::uint64_t seed = 1;                             // of all random inputs
  bool anonymous = false;                             // messages must not name anybody
  int threads = 1;     // per submission; verdicts do not depend on it
  std::string work{};  // the program's folder for its builds; empty: the usual one
};

// The outcome for one submission.
struct Graded {
  intake::HandedIn by;
  results::Results results{};  // empty if there is a problem
  std::string problem{};       // the reason why it was not judged, one sentence; else empty
  bool again = false;          // an earlier outcome that still holds
  bool changed =
      false;  // meanwhile (files or plan): the problem is not kept, and it is judged again
};

// Removes files of earlier calls that would look like outcomes of this call: problems, and reports
// of submissions with nothing to judge any more.
void forget_outcomes(const std::string& out, const std::vector<intake::HandedIn>& everybody);

// The earlier outcome of a submission: its reports, if they are complete and made from the same
// files with the same options by the same judge; else its problem.
Graded graded_before(const Judging& judging, const intake::HandedIn& by);

// Returns whether grade_equal has finished it: there are such reports, or there is a problem.
bool is_done(const Judging& judging, const intake::HandedIn& by);

// A text that changes whenever is_done may have become true. Does not read the submission.
std::string outcome_so_far(const Judging& judging, const intake::HandedIn& by);

// Judges submissions whose files are equal, and writes their reports. It reuses earlier reports,
// results that differ only in points (which are recounted), and results of an equal submission. It
// waits for another process that judges the same files. If another plan has been made meanwhile, it
// judges nothing: the new plan may have other files of the same learners. `report` gets each
// outcome as soon as it is known, by its place in `equal`.
void grade_equal(const Judging& judging, const std::vector<intake::HandedIn>& equal,
                 const std::function<void(std::size_t, const Graded&)>& report);

}  // namespace grader::classes
