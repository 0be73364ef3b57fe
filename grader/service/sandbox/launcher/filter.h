#pragma once

namespace grader::sandbox::box {

// From now on this process and its descendants can only make the system calls that a worker needs,
// or a compiler if `tools`. Calls of attacks end the process (SIGSYS), and all others fail with
// EPERM: docs/decisions/0020 lists them with the reasons. The program that is open as `program` may
// still be started. Does nothing in a build without libseccomp. Throws pt::Error if the kernel
// refuses.
void filter_system_calls(int program, bool tools);

}  // namespace grader::sandbox::box
