#include "pt/scene/collada/twins.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace pt {

namespace {

struct FanCorner {
  Vec3 p, n;
};

// A flat face of four corners or more, as the loader cuts it: triangles `first` and after it, around the first corner.
struct Fan {
  std::size_t first;
  std::vector<FanCorner> corners;
};

bool goes_on(const Triangle& a, const Triangle& b) {
  if (!(a.p0 == b.p0 && a.p2 == b.p1)) return false;
  const Vec3 n = geometric_normal(a), m = geometric_normal(b);
  return dot(n, m) > 0 && length(cross(n, m)) <= 1e-9 * length(n) * length(m);
}

std::vector<Fan> fans_of(const Scene& scene) {
  const std::vector<Triangle>& all = scene.primitives.triangles;
  std::vector<Fan> fans;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && scene.material_of[end] == scene.material_of[i] &&
           goes_on(all[end - 1], all[end])) {
      ++end;
    }
    if (end - i > 1) {
      Fan fan{i, {{all[i].p0, all[i].n0}, {all[i].p1, all[i].n1}}};
      for (std::size_t k = i; k < end; ++k) fan.corners.push_back({all[k].p2, all[k].n2});
      fans.push_back(std::move(fan));
    }
    i = end;
  }
  return fans;
}

// The corner of `other` from which it runs through the corners of `fan`, forwards or backwards.
std::optional<std::size_t> start_of(const Fan& fan, const Fan& other) {
  const std::size_t n = fan.corners.size();
  if (other.corners.size() != n) return std::nullopt;
  for (std::size_t k = 0; k < n; ++k) {
    for (const std::size_t step : {std::size_t{1}, n - 1}) {
      std::size_t m = 0;
      while (m < n && fan.corners[m].p == other.corners[(k + m * step) % n].p) ++m;
      if (m == n) return k;
    }
  }
  return std::nullopt;
}

void cut_from(std::size_t start, const Fan& fan, std::vector<Triangle>& all) {
  const std::size_t n = fan.corners.size();
  const auto corner = [&](std::size_t m) { return fan.corners[(start + m) % n]; };
  for (std::size_t m = 0; m + 2 < n; ++m) {
    const FanCorner a = corner(0), b = corner(m + 1), c = corner(m + 2);
    all[fan.first + m] = {a.p, b.p, c.p, a.n, b.n, c.n};
  }
}

}  // namespace

void share_diagonals(Scene& scene) {
  const std::vector<Fan> fans = fans_of(scene);
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < fans.size(); ++i) {
    std::uint64_t hash = 0;
    for (const FanCorner& corner : fans[i].corners) hash += hash_of(corner.p);
    order.emplace_back(hash, i);
  }
  std::sort(order.begin(), order.end());
  std::size_t first = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].first != order[first].first) first = i;
    if (first == i) continue;
    const Fan& other = fans[order[i].second];
    const auto start = start_of(fans[order[first].second], other);
    if (start && *start != 0) cut_from(*start, other, scene.primitives.triangles);
  }
}

}  // namespace pt
