#pragma once

#include "grader/judge/config.h"
#include "grader/results/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// A class: a folder with a folder for each submission, graded one after the other.

namespace grader::programs {

struct ClassRequest {
  std::string folder;
  std::string out;                 // where reports go: <submission>.json and .html, and class.csv
  std::string grade;               // the program
  std::vector<std::string> words;  // of its command line, the same for all
  std::uint64_t seed = 1;          // of all random inputs
};

// The outcome for one submission.
struct Graded {
  std::string name;          // of its folder
  results::Results results;  // if there is no problem
  std::string problem;       // why it was not judged, in one sentence; else empty
  bool again = false;        // it was judged before, and nothing has changed since
};

// The names of the folders in the class, in alphabetical order; links and hidden ones are left out.
// Throws pt::Error if there are none.
std::vector<std::string> submissions_of(const std::string& folder);

// The seed of a class: the one asked for, else the one with which the reports in the folder were
// made, else a new one, drawn: a table of answers to one seed is worth nothing then. It is kept in
// the folder.
std::uint64_t seed_for(const std::string& out, std::optional<std::uint64_t> asked);

// Runs the program on one submission, unless its reports are there, complete, and made from the
// same files with the same words by the same judge.
Graded grade_one(const judge::Config& config, const ClassRequest& request, const std::string& name);

// A line per submission: points, and the state and points of every task (RFC 4180).
std::string class_table(const judge::Config& config, const std::vector<Graded>& all);

}  // namespace grader::programs
