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
    too_long,  // it used the processor time that an example has
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
  std::chrono::milliseconds most{1000};  // of processor time, for each example
};

// Runs these examples (by their numbers; all if `only` is empty) with the solution of that number, or with the one that is linked if
// there is no number. An example that ends the program or takes too long fails, and the next one runs; after three that take too long no
// other runs. `until_one_fails`: nothing runs after the first that does not hold.
Run run_examples(const Program& program, std::optional<std::size_t> solution,
                 const std::optional<std::vector<std::size_t>>& only = {},
                 bool until_one_fails = false);

}  // namespace grader::examples
