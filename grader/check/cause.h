#pragma once

#include <string>

namespace grader::check {

// Why a case failed. All but the first are known in graded runs only, where the task runs in
// another process: the call itself came to nothing.
enum class Cause {
  wrong,          // the answer is not what was promised
  crash,          // the process died, or the task threw
  timeout,        // no answer within the limit
  bad_reply,      // an answer that no implementation of the contract can give
  not_attempted,  // the task calls todo()
};
const char* name(Cause cause);

// Makes the case fail because a call gave no answer; `got` says what it did instead.
[[noreturn]] void fail_call(Cause cause, const std::string& got);

}  // namespace grader::check
