#pragma once

#include "grader/service/build/config.h"
#include "grader/service/intake/handed_in.h"

#include <string>

namespace grader::classes {

// Returns a function that unpacks archives in the best box that works here. The box can only read
// the open archive and write in the folder. Its limits, beyond those of intake::unpack: one minute
// of processor time (one hour for a class), 2 GiB of memory, no other process. The function throws
// pt::Error if the machine is at fault: the box does not start or is killed, or the disk is full.
// `programs` is the folder of the program `unpack`. Throws pt::Error if `must_isolate` and nothing
// isolates here.
intake::Unpack unpack_boxed(const build::Config& config, const std::string& programs,
                            bool must_isolate);

}  // namespace grader::classes
