#pragma once

#include <vector>

namespace grader::sandbox::box {

// Runs a part of a tool that is already in a box, for a compiler's driver (gcc, -wrapper), and
// returns its exit status. The driver only prints how a part ended, mixed with text that may be the
// submission's. So this writes to the descriptor `parts`, which the part does not get: 'b' before
// the part begins, 'f' if it failed by itself (not if SIGKILL ended it or this program).
int run_tool_part(const std::vector<char*>& command, int parts);

}  // namespace grader::sandbox::box
