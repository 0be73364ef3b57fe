#pragma once

#include "pt/scene/scene.h"

namespace pt {

// Gives the scene its tracer. The tree of the tasks is tried with one ray first; where one of its
// tasks is a stub there will be no tree at all, and the tracer's engine is linear: part 1 shows its
// pictures before part 2 is written.
void choose_engine(Scene& scene, Engine engine, int max_leaf);

}  // namespace pt
