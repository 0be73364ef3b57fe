#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <stack>
#include <utility>
#include <vector>

namespace pt {

std::optional<Hit> hit_bvh(const Bvh&, const Primitives&, const Ray&) { return {}; }
bool occluded_bvh(const Bvh&, const Primitives&, const Ray&) { return false; }

}  // namespace pt
