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

namespace {

bool enters(const Bvh& bvh, const Ray& ray) {
  if (bvh.nodes.empty() || !hit_box(bvh.nodes[0].box, ray)) return false;
  if (bvh.nodes[0].is_leaf()) return true;
  const bool left = hit_box(bvh.nodes[bvh.nodes[0].left].box, ray).has_value();
  return hit_box(bvh.nodes[bvh.nodes[0].right].box, ray).has_value() || left;
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  Ray shortened = ray;
  std::optional<Hit> best;
  if (!enters(bvh, ray)) return best;
  for (int i = 0; i < primitives.size(); ++i) {
    if (const auto hit = hit_primitive(primitives, i, shortened)) {
      best = Hit{hit->t, hit->n, i};
      shortened.t_max = hit->t;
    }
  }
  return best;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  if (!enters(bvh, ray)) return false;
  for (int i = 0; i < primitives.size(); ++i) {
    if (hit_primitive(primitives, i, ray)) return true;
  }
  return false;
}

}  // namespace pt
