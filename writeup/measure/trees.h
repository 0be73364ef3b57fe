#pragma once

#include "pt/tasks/build_bvh.h"
#include "pt/tasks/hit_bvh.h"
#include "writeup/measure/exact.h"

#include <optional>
#include <vector>

// Trees and the rays that are sent through them.

namespace writeup::measure {

inline constexpr int kRays = 512;

struct TreeInputs {
  pt::Primitives primitives;
  std::vector<pt::Box> boxes;
  std::vector<pt::Ray> rays;                   // half from a camera, half from anywhere
  std::vector<pt::Ray> shadow_rays;            // from the same places, each to a point
  std::vector<std::optional<double>> nearest;  // t, by testing every primitive
  std::vector<bool> occluded;
};

// Always the same.
const TreeInputs& tree_inputs();

// Sends the rays through the tree; `any`: the shadow rays, of which any hit will do.
Found query(const pt::Bvh& bvh, bool any);

}  // namespace writeup::measure
