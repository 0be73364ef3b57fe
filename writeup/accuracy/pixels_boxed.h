#pragma once

#include "pt/scene/tracer.h"
#include "writeup/boxed.h"

namespace writeup::accuracy {

// Pixels are made by this submission from now on. Throws SubmissionFailed if it cannot make any: a task
// that all pixels need does not compile.
void open_boxed(const Boxed& boxed, pt::Engine engine);

}  // namespace writeup::accuracy
