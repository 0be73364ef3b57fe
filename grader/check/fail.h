#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::check {

// Thrown by what ends a case as failed: what, got, expected, off_by and cause are filled.
struct CaseFailed {
  results::Failure failure;
};

// Ends the case as failed, with texts for a person to read; empty where there is nothing to say.
// For the functions that properties call (expect_...), not for the properties themselves.
[[noreturn]] void fail(const std::string& what, const std::string& got, const std::string& expected,
                       const std::string& off_by = "");

}  // namespace grader::check
