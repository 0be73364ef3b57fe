#pragma once

#include "grader/intake/handed_in.h"
#include "grader/judge/config.h"
#include "grader/report/platforms.h"
#include "grader/results/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Grades the submissions of a class, several at a time.

namespace grader::programs {

struct ClassRequest {
  std::string input;               // a folder or an archive
  std::string out;                 // where reports go: <submission>.json and .html, and class.csv
  std::string grade;               // the program
  std::vector<std::string> words;  // of its command line, the same for all
  std::uint64_t seed = 1;          // of all random inputs
  int jobs = 1;                    // submissions at a time
};

// The outcome for one submission.
struct Graded {
  intake::HandedIn by;
  results::Results results;  // if there is no problem
  std::string problem;       // why it was not judged, in one sentence; else empty
  bool again = false;        // it was judged before, and nothing has changed since
};

// Lists the submissions of the class. The program `unpack` unpacks archives, below request.out. Throws
// pt::Error if there are none.
std::vector<intake::HandedIn> handed_in(const ClassRequest& request);

// The seed of a class: the one asked for, else the one with which the reports in the folder were
// made, else a new one, drawn: a table of answers to one seed is worth nothing then. It is kept in
// the folder.
std::uint64_t seed_for(const std::string& out, std::optional<std::uint64_t> asked);

// Runs the program on one submission, unless its reports are there, complete, and made from the
// same files with the same words by the same judge.
Graded grade_one(const judge::Config& config, const ClassRequest& request,
                 const intake::HandedIn& by);

// Writes the files that the learning platforms take back: canvas.csv and moodle.csv, and
// feedback.zip with every page under the path by which its platform knows it. Returns their paths.
class Returns {
 public:
  void add(const Graded& graded);
  std::vector<std::string> write(const ClassRequest& request) const;

 private:
  std::vector<std::pair<intake::HandedIn, report::GradeRow>> all_;
  int max_points_ = 0;
};

// class.csv (RFC 4180): its first line, and one for a submission: who, points, and the state and points of
// every task.
std::string class_header(const judge::Config& config);
std::string class_line(const judge::Config& config, const Graded& graded);

}  // namespace grader::programs
