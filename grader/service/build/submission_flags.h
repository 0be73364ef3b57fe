#pragma once

#include <array>
#include <string_view>

// The flags for compiling a submission, in addition to the flags for all code
// (Config::compile_flags).

namespace grader::build {

// Warnings that point to a mistake, but none on what everybody writes (int i < size()).
inline constexpr std::array kSubmissionFlags{
    "-Wall",
    "-Wextra",
    "-Wshadow",
    "-Wconversion",
    "-Wno-sign-conversion",
    "-Wno-sign-compare",
    "-Wno-unknown-pragmas",
};

// This warning means that a function may end without returning its value. With the flags below, the
// program then ends at that point instead of doing anything at all. But these flags silence the
// warning, so a file is compiled without them first.
inline constexpr std::string_view kNoReturn = "[-Wreturn-type]";
inline constexpr std::array kTrapFlags{"-fsanitize=return", "-fsanitize-undefined-trap-on-error"};

}  // namespace grader::build
