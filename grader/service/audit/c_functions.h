#pragma once

#include <string_view>

namespace grader::audit {

// Returns whether compiled C++ may need this C function: a function of ISO C that computes, prints
// or ends the program, or one that compilers insert calls to. Functions that use the operating
// system are not among them: fork, socket, dlopen, open, write, system, syscall, pthread_create,
// ...
bool is_harmless(std::string_view name);

}  // namespace grader::audit
