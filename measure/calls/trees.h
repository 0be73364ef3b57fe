#pragma once

#include "measure/calls/exact.h"
#include "pt/tasks/build_bvh.h"
#include "pt/tasks/hit_bvh.h"

#include <optional>
#include <vector>

// Trees and the rays that are sent through them.

namespace measure::calls {

inline constexpr int kRays = 512;

struct TreeInputs {
  pt::Primitives primitives;
  std::vector<pt::Box> boxes;
  std::vector<pt::Ray> rays;                   // half from a camera, half from random places
  std::vector<pt::Ray> shadow_rays;            // from the same places, each to a point
  std::vector<std::optional<double>> nearest;  // t, by testing every primitive
  std::vector<bool> occluded;
};

// Always the same.
const TreeInputs& tree_inputs();

// Sends the rays through the tree; `any`: the shadow rays, for which any hit is enough.
Found query(const pt::Bvh& bvh, bool any);

}  // namespace measure::calls
