#pragma once

#include "grader/examples/judge.h"
#include "grader/mistakes/known.h"

#include <set>
#include <string>
#include <vector>

// The hunt: one wrong solution is chosen for each learner, who has to find an input at which it is wrong.

namespace grader::examples {

struct Quarry {
  std::size_t number = 0;  // its place among all solutions
  std::size_t one_of = 0;  // so many could have been chosen
};

// Chooses one of the mistakes that ordinary inputs show. Throws pt::Error if there are none.
Quarry choose(const std::vector<mistakes::Solution>& solutions, const std::string& slug,
              std::uint64_t seed);

// The seed of this learner on this machine: nobody has to choose one.
std::uint64_t seed_of_learner();

// All that is known of the mistake. `source` is empty in a handout, which has no text of any solution.
struct Found {
  mistakes::Fingerprint mistake;
  std::string source;
};
Found found(const std::string& root, const std::string& programs, const std::string& slug,
            const std::string& name);

// The source with the numbers of its lines. `marked`: a > stands before each line that no right solution has.
std::string numbered(const std::string& source, const std::set<std::string>& right_lines,
                     bool marked);

// The lines of all right solutions of the task, without the blanks around them.
std::set<std::string> lines_of_right(const std::string& root, const std::string& part,
                                     const std::string& slug);

}  // namespace grader::examples
