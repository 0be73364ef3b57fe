#pragma once

#include <vector>

namespace grader::sandbox::box {

// Runs a part of a tool that is in a box already, as a compiler's driver starts it (gcc, -wrapper), and
// returns its exit status. The driver only prints how a part ended, among words which may be the
// submission's; so bytes go to the descriptor `parts`, which the part does not get: 'b' before it begins, and 'f' if it
// failed by itself: not if SIGKILL ended it, or this program.
int run_tool_part(const std::vector<char*>& command, int parts);

}  // namespace grader::sandbox::box
