#pragma once

#include "pt/scene/scene.h"

#include <array>
#include <string_view>

namespace pt {

// The slugs of the tasks that the tree needs: if one is missing, there is no tree.
// tests/grader/tasks/tasks_test compares them with the table of tasks.
inline constexpr std::array<std::string_view, 3> kTreeTasks{"build_bvh", "hit_box", "hit_bvh"};

// Gives the scene its tracer. It first tries the tree of the tasks with one ray. If one of its
// tasks is a stub, there is no tree, and the tracer's engine is linear, so that part 1 shows its
// pictures before part 2 is written.
void choose_engine(Scene& scene, Engine engine, int max_leaf);

}  // namespace pt
