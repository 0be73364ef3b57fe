#pragma once

#include "grader/examples/judge.h"
#include "grader/report/hints.h"
#include "grader/results/promises.h"

#include <string>
#include <vector>

// The verdicts on a learner's examples, as text.

namespace grader::examples {

// The texts of a task.
struct Texts {
  std::string slug;
  std::vector<results::Promise> promises;
  report::Hints hints;
  std::string
      precision;  // the paragraph of the contract that says what it leaves open; may be empty
};

// Reads them from the contract and the hints of a task. `root`: the folder of the project.
Texts texts_of(const std::string& root, const std::string& slug);

// Of the ordinary mistakes that break a promise, how many are caught.
struct Share {
  results::Promise promise;
  std::size_t caught = 0, all = 0;
};
// For each promise that has such mistakes.
std::vector<Share> shares(const Verdicts& verdicts, const std::vector<results::Promise>& promises);

// A line for each example.
std::string rows_text(const Verdicts& verdicts);

// Names no mistake: they are counted by the promises that they break.
std::string to_text(const Verdicts& verdicts, const Texts& texts);

// The verdict of the valid examples on the learner's own function.
std::string own_text(const Verdicts& verdicts, const Run& own, const std::string& slug);

}  // namespace grader::examples
