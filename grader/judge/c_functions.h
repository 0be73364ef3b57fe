#pragma once

#include <string_view>

namespace grader::judge {

// Returns whether a name that is not C++'s is one that compiled C++ may need: functions of ISO C
// that compute, print or end the program, and what compilers call by themselves. Not those that
// reach for the operating system: fork, socket, dlopen, open, write, system, syscall,
// pthread_create, ...
bool is_harmless(std::string_view name);

}  // namespace grader::judge
