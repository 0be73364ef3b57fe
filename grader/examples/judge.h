#pragma once

#include "grader/examples/run.h"
#include "grader/mistakes/solutions.h"

#include <optional>
#include <string>
#include <vector>

// The worth of a learner's examples: each is held against all right solutions of its task, and the valid ones against all mistakes.

namespace grader::examples {

enum class Verdict {
  valid,       // every right solution accepts it
  wrong,       // none does
  too_strict,  // some do not: the contract leaves this open
  empty,       // it checks nothing
  unsteady,    // the same solution once accepts it and once does not
};

struct Judged {
  std::string name;
  Verdict verdict = Verdict::wrong;
  std::string words;  // what a right solution does instead
  int against = 0;    // the number of right solutions that do not accept it
};

struct Verdicts {
  std::vector<Judged> examples;
  std::string fault;  // how the program ended before the first example; empty if it did not
  int rights = 0;
  std::vector<mistakes::Solution> mistakes;
  // caught[m]: the first valid example that mistake m fails.
  std::vector<std::optional<std::size_t>> caught;

  std::vector<std::size_t> valid() const;
};

// Runs the examples with all solutions, or with all right ones and one mistake (its place in `solutions`). In the program the solutions
// have the numbers of their places.
Verdicts judge(const Program& program, const std::vector<mistakes::Solution>& solutions,
               int threads, std::optional<std::size_t> only_mistake = {});

}  // namespace grader::examples
