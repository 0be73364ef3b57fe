#pragma once

#include "grader/results/results.h"
#include "grader/results/summary.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace grader::platforms {

// One submission of a class, as its page lists it.
struct ClassRow {
  std::string name;
  std::string id;       // of the learning platform; may be empty
  std::string page;     // the file of its report, next to the class page
  std::string problem;  // the reason why it was not judged; else empty
  bool late = false;
  std::string note{};   // on the files that were judged; may be empty
  bool absent = false;  // nothing was handed in: 0 points
  std::string grade{};  // one sentence where it is not that of the points; may be empty
};

// The page of a class: a row per submission, and the parts that were hard for the class. Results
// are counted and not kept, so that a thousand submissions need little memory.
class ClassPage {
 public:
  // `results` count if there is no problem.
  void add(const ClassRow& row, const results::Results& results);

  // Rows in alphabetical order. The page is one file, readable without network and scripts.
  std::string to_html() const;

  // For a promise or a picture: the numbers of submissions that were judged by it, that passed it,
  // and in which it is the first failure of its task.
  struct Count {
    std::string title;
    int judged = 0;
    int right = 0;
    int first = 0;
  };
  struct Entry {
    ClassRow row;
    results::Totals sums;
    std::map<std::string, results::State> tasks;  // by slug
    double seconds = 0;
  };
  using Key = std::pair<std::string, std::string>;  // task, and promise, recipe or mistake
  using Counts = std::map<Key, Count>;

 private:
  void count(const results::TaskResult& task);

  std::vector<Entry> lines_;
  std::vector<std::string> tasks_;  // slugs, in the order of the course
  Counts promises_, pictures_;
  Counts examples_;              // by promise: whether the learner's examples catch what breaks it
  std::map<Key, int> mistakes_;  // by task and sentence
};

}  // namespace grader::platforms
