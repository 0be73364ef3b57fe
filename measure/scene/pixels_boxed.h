#pragma once

#include "measure/renders/boxed.h"
#include "pt/scene/tracer.h"

namespace measure::scene {

// From now on this submission renders the pixels. Throws SubmissionFailed if a task that all pixels
// need does not compile.
void open_boxed(const Boxed& boxed, pt::Engine engine);

}  // namespace measure::scene
