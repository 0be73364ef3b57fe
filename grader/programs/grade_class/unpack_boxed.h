#pragma once

#include "grader/intake/handed_in.h"
#include "grader/judge/config.h"

#include <string>

namespace grader::programs {

// Returns a function that unpacks archives in the best box that works here. The box can read the open archive and write in the
// folder, and nothing else. It has more bounds than intake::unpack: a minute of processor time (an hour for a class), 2 GiB of
// memory, no other process. The function throws pt::Error where the machine is at fault: the box does not start or is killed, or
// the disk is full. `programs` is the folder of the program `unpack`. Throws pt::Error if `must_isolate` and nothing isolates here.
intake::Unpack unpack_boxed(const judge::Config& config, const std::string& programs,
                            bool must_isolate);

}  // namespace grader::programs
