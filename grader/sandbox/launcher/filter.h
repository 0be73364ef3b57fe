#pragma once

namespace grader::sandbox::box {

// From now on this process and all that come from it make only the system calls that a worker
// needs, or a compiler if `tools`. The calls of attacks end the process (SIGSYS), and all others fail with EPERM:
// docs/decisions/0020 says which, and why. One program may still be started:
// the one open as `program`. Built without libseccomp, it does nothing. Throws pt::Error if the
// kernel refuses.
void filter_system_calls(int program, bool tools);

}  // namespace grader::sandbox::box
