#pragma once

namespace grader::sandbox::box {

// From now on this process and all that come from it make only the system calls that a worker
// needs, or a compiler if `tools`; all others fail with EPERM. One program may still be started:
// the one open as `program`. Built without libseccomp, it does nothing. Throws pt::Error if the
// kernel refuses.
void filter_system_calls(int program, bool tools);

}  // namespace grader::sandbox::box
