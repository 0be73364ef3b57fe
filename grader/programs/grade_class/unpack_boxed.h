#pragma once

#include "grader/intake/handed_in.h"
#include "grader/judge/config.h"

#include <string>

namespace grader::programs {

// Unpacks archives in a box, the best that works here: it sees the archive, which is open, and may write in the
// folder alone. Bounds besides those of intake::unpack: a minute of processor time (an hour for a whole class), 2 GiB of memory, no
// other process. Throws pt::Error where the machine is at fault: the box does not start or is killed, the disk is full. `programs` is the folder of the program `unpack`. Throws too if nothing
// isolates here and it must.
intake::Unpack unpack_boxed(const judge::Config& config, const std::string& programs,
                            bool must_isolate);

}  // namespace grader::programs
