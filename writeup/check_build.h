#pragma once

#include "writeup/code.h"
#include "writeup/options.h"

#include <optional>

namespace writeup {

// The programs of the build that grades, which compile and run tasks in boxes of their own. Nothing
// where they have not been built, or their folder is not named.

// Measures curves; its hash has what the curves of each task depend on. With the learner's own line
// where somebody else's code than the reference is written about.
std::optional<Code> code_of_stability(const Options& options);

// Takes the time of the right solutions that are kept in the tree. `code` is that of the reference.
std::optional<Code> code_of_measure(const Options& options, const Code& code);

}  // namespace writeup
