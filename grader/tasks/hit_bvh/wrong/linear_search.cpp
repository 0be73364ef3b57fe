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

std::optional<Hit> hit_bvh(const Bvh&, const Primitives& primitives, const Ray& ray) {
  Ray shortened = ray;
  std::optional<Hit> best;

  for (int i = 0; i < primitives.size(); ++i) {
    if (const auto hit = hit_primitive(primitives, i, shortened)) {
      best = Hit{hit->t, hit->n, i};
      shortened.t_max = hit->t;
    }
  }
  return best;
}

bool occluded_bvh(const Bvh&, const Primitives& primitives, const Ray& ray) {
  for (int i = 0; i < primitives.size(); ++i) {
    if (hit_primitive(primitives, i, ray)) return true;
  }
  return false;
}

}  // namespace pt
