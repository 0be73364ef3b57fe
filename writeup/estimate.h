#pragma once

#include "writeup/spec.h"

namespace writeup {

// About how many seconds of one processor a render takes that was never made before.
double estimated_seconds(const Spec& spec);

}  // namespace writeup
