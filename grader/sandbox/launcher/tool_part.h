#pragma once

#include <vector>

namespace grader::sandbox::box {

// Runs a part of a tool that is in a box already, as a compiler's driver starts it (gcc, -wrapper), and
// returns its exit status. One byte goes to the descriptor `killed` if SIGKILL ended it: the driver
// only prints that, among words which may be the submission's. The part does not get the descriptor.
int run_tool_part(const std::vector<char*>& command, int killed);

}  // namespace grader::sandbox::box
