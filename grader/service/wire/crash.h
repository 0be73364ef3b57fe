#pragma once

// The worker's end: distinguishes stack overflows from other crashes.

namespace grader::wire {

// From now on a stack overflow ends this process with SIGSTKFLT, which nothing else sends, instead
// of the signal for any wrong address. Call it in main().
void report_stack_overflow();

}  // namespace grader::wire
