#pragma once

#include "grader/service/sandbox/box.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

// One run of a learner's examples with one solution, in a box.

namespace grader::examples {

struct Outcome {
  enum class Kind {
    unknown,  // it did not run
    holds,
    fails,
    ends,      // the program ended while it ran
    too_long,  // it used all the processor time of the run
  };
  Kind kind = Kind::unknown;
  std::string words;  // the reason, if it does not hold
  int checks = 0;

  bool holds() const { return kind == Kind::holds; }
  bool is_known() const { return kind != Kind::unknown; }
};

struct Run {
  std::vector<std::string> names;  // of all examples of the file
  std::vector<Outcome> outcomes;   // of each of them
  std::vector<std::string> todo;   // the tasks that were called and are not written
  std::string fault;  // how the program ended before its first example; empty if it did not
};

struct Program {
  std::string path;
  sandbox::Tier tier = sandbox::Tier::limits;
  std::chrono::milliseconds most{1000};  // of processor time, for each run
};

// Runs these examples (by their numbers; all if `only` is empty) with the solution of that number, or with the one that is linked if
// there is no number. An example that ends the program fails, and the next one runs. After an example that takes too long, no other runs.
Run run_examples(const Program& program, std::optional<std::size_t> solution,
                 const std::optional<std::vector<std::size_t>>& only = {});

}  // namespace grader::examples
