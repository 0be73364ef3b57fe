#pragma once

#include "pt/scene/view.h"

#include <string>

namespace pt {

// Says why nothing can be seen in a picture at that exposure, and what to do; empty if something
// can. `brightest` is its largest channel. The scene has a light. Of a black picture it first names
// the tasks that are stubs; other reasons are looked for by rays that call no task.
std::string note_on_darkness(const View& view, double brightest, double exposure);

}  // namespace pt
