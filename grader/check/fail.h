#pragma once

#include <string>

namespace grader::check {

// Ends the case as failed, with texts for a person to read; empty where there is nothing to say.
// For the functions that properties call (expect_...), not for the properties themselves.
[[noreturn]] void fail(const std::string& what, const std::string& got, const std::string& expected,
                       const std::string& off_by = "");

}  // namespace grader::check
