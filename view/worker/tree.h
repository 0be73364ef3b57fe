#pragma once

#include "pt/geometry/bvh.h"

#include <nlohmann/json.hpp>

namespace view {

// The boxes of a tree with their levels, and what it costs: the mean number of tests of a ray that meets the box of all, by the areas of the
// boxes (the surface area heuristic). Links that break the invariants of pt/geometry/bvh.h are not followed.
nlohmann::json tree_of(const pt::Bvh& bvh);

}  // namespace view
