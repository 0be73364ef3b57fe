#pragma once

#include "writeup/code.h"
#include "writeup/options.h"

#include <optional>

namespace writeup {

// Programs of the grading build, which compile and run tasks in their own boxes. The functions
// return nothing if the programs have not been built, or their folder is not named.

// The program that measures curves. Its hash has everything that the curves of a task depend on. If
// the write-up is not about the reference, the curves have a line for its code.
std::optional<Code> code_of_stability(const Options& options);

// The program that times the right solutions of the tree. `code` is the reference's.
std::optional<Code> code_of_measure(const Options& options, const Code& code);

}  // namespace writeup
