#pragma once

#include <array>
#include <string_view>

// The flags with which a submission is compiled, in addition to those that the build has for everything
// (Config::compile_flags).

namespace grader::judge {

// Warnings that name the guilty line of a mistake, and not what everybody writes (int i < size()).
inline constexpr std::array kSubmissionFlags{
    "-Wall",
    "-Wextra",
    "-Wshadow",
    "-Wconversion",
    "-Wno-sign-conversion",
    "-Wno-sign-compare",
    "-Wno-unknown-pragmas",
};

// This warning says that a function has to return a value and may end without a return. With the
// flags below it ends the program there, where anything could happen otherwise. The compiler is then
// silent about it, so a file is compiled without them first.
inline constexpr std::string_view kNoReturn = "[-Wreturn-type]";
inline constexpr std::array kTrapFlags{"-fsanitize=return", "-fsanitize-undefined-trap-on-error"};

}  // namespace grader::judge
