#pragma once

#include "pt/scene/scene.h"

#include <nlohmann/json.hpp>

namespace view {

// The boxes of a tree with their levels, and what it costs: the mean number of tests of a ray that meets the box of all, by the areas of the
// boxes (the surface area heuristic). Links that break the invariants of pt/geometry/bvh.h are not followed.
nlohmann::json tree_of(const pt::Bvh& bvh);

// The boxes that hit_bvh tests to find the nearest hit of a ray, in its order, with the t at which the ray enters and leaves each of
// them; of leaves the primitives that were tested. It is empty for engines without the task.
nlohmann::json tests_of(const pt::Scene& scene, const pt::Ray& ray);

}  // namespace view
