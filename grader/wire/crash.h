#pragma once

// The worker's end: how a crash is told apart.

namespace grader::wire {

// From now on a stack that overflows ends this process with the signal SIGSTKFLT, which nothing
// else sends, and not with that of any wrong address. To be called by main().
void report_stack_overflow();

}  // namespace grader::wire
