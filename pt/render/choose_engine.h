#pragma once

#include "pt/scene/scene.h"

#include <array>
#include <string_view>

namespace pt {

// The tasks of the tree, slugs: without one of them there is no tree. self_check/tasks_test compares
// them with the table of tasks.
inline constexpr std::array<std::string_view, 3> kTreeTasks{"build_bvh", "hit_box", "hit_bvh"};

// Gives the scene its tracer. The tree of the tasks is tried with one ray first; where one of its
// tasks is a stub there will be no tree at all, and the tracer's engine is linear: part 1 shows its
// pictures before part 2 is written.
void choose_engine(Scene& scene, Engine engine, int max_leaf);

}  // namespace pt
