#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::check {

// Thrown to end a case as failed. The fields from what to statistical are filled.
struct CaseFailed {
  results::Failure failure;
};

// Ends the case as failed, with texts for a person to read. A text may be empty. This function is
// for the functions that properties call (expect_...), not for the properties themselves.
[[noreturn]] void fail(const std::string& what, const std::string& got, const std::string& expected,
                       const std::string& off_by = "");
[[noreturn]] void fail_statistical(const std::string& what, const std::string& got,
                                   const std::string& expected, const std::string& off_by = "");

// Says how far a value is off, and by which factor if there is one: factors like 2 or pi often name the mistake.
std::string off_by(double got, double expected);

// Ends the case because a call gave no answer. `got` says what the call did instead.
[[noreturn]] void fail_call(results::Cause cause, const std::string& got);

}  // namespace grader::check
