#pragma once

#include "grader/intake/handed_in.h"
#include "grader/judge/config.h"
#include "grader/results/results.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

// One submission of a class, with its reports in a folder:
//   <name>.json, <name>.html   the reports
//   <name>.key                 stands for all that they depend on; written last
//   <name>.problem             the plan's ID, and why it was not judged; not where its files
//                              changed meanwhile: then it is judged again

namespace grader::programs {

// The settings with which everybody in the class is judged.
struct Judging {
  const judge::Config& config;
  std::string grade;     // the program
  std::string out;       // the folder of the reports
  std::string plan;      // the ID of the plan in it
  std::string former{};  // the folder of an earlier grading, whose results may be used again
  std::map<std::string, std::string> former_names{};  // name now -> name there
  std::vector<std::string> words{};                   // of the program's command line
  std::uint64_t seed = 1;                             // of all random inputs
  bool anonymous = false;                             // problems must name nobody
  int threads = 1;     // of one submission; verdicts do not depend on it
  std::string work{};  // the program's folder for its builds; empty: the usual one
};

// The outcome for one submission.
struct Graded {
  intake::HandedIn by;
  results::Results results{};  // if there is no problem
  std::string problem{};       // the reason why it was not judged, one sentence; else empty
  bool again = false;          // it was judged before, and nothing has changed since
  bool changed =
      false;  // it, or the plan, meanwhile, so the problem does not stay: it is judged again
};

// Removes what earlier calls left that must not be taken for an outcome of this one: problems, and
// reports of a submission in which there is nothing to judge any more.
void forget_outcomes(const std::string& out, const std::vector<intake::HandedIn>& everybody);

// The earlier outcome of a submission: its reports, if they are complete and made from the same files with
// the same words by the same judge; else its problem.
Graded graded_before(const Judging& judging, const intake::HandedIn& by);

// Returns whether grade_equal is done with it: there are such reports, or there is a problem.
bool is_done(const Judging& judging, const intake::HandedIn& by);

// A text that changes whenever is_done may have become true. Does not read what was handed in.
std::string outcome_so_far(const Judging& judging, const intake::HandedIn& by);

// Judges submissions whose files are equal, and writes their reports. Earlier outcomes are used again:
// reports of before; results that differ in points only, which are counted again; those of an equal
// submission. Another process that judges the same is waited for. If another plan has been made meanwhile,
// nothing is judged: that plan may have other files of the same learners.
std::vector<Graded> grade_equal(const Judging& judging, const std::vector<intake::HandedIn>& equal);

}  // namespace grader::programs
