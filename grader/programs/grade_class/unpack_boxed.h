#pragma once

#include "grader/intake/handed_in.h"
#include "grader/judge/config.h"

#include <string>

namespace grader::programs {

// Unpacks archives in a box, the best that works here: it sees the archive, which is open, and may write in the
// folder alone. Bounds besides those of intake::unpack: 60 s of processor time, five minutes, 2 GiB of memory.
// `programs` is the folder of the program `unpack`.
intake::Unpack unpack_boxed(const judge::Config& config, const std::string& programs);

}  // namespace grader::programs
