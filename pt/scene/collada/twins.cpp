#include "pt/scene/collada/twins.h"

#include "pt/accel/wide_bvh.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace pt {

namespace {

// The same for all orders of the corners.
std::uint64_t hash_of_primitive(const Primitives& all, int i) {
  if (!all.is_triangle(i)) return hash_of(all.sphere(i).center) + 1;
  const Triangle& t = all.triangle(i);
  return hash_of(t.p0) + hash_of(t.p1) + hash_of(t.p2);
}

enum class Relation { none, equal, opposite };

Relation relation(const Primitives& all, int i, int j) {
  if (all.is_triangle(i) != all.is_triangle(j)) return Relation::none;
  if (!all.is_triangle(i)) {
    const Sphere &a = all.sphere(i), &b = all.sphere(j);
    const bool same = a.center == b.center && a.radius == b.radius;
    return same ? Relation::equal : Relation::none;
  }
  const Triangle &a = all.triangle(i), &b = all.triangle(j);
  const Vec3 corners[3] = {a.p0, a.p1, a.p2};
  for (int k = 0; k < 3; ++k) {
    const Vec3 next = corners[(k + 1) % 3], last = corners[(k + 2) % 3];
    if (!(corners[k] == b.p0)) continue;
    if (next == b.p1 && last == b.p2) return Relation::equal;
    if (next == b.p2 && last == b.p1) return Relation::opposite;
  }
  return Relation::none;
}

// A surface that stays, and the primitives whose materials its sides show; -1: nothing lies there.
struct Sides {
  int front;
  int back = -1;
};

class Merge {
 public:
  explicit Merge(Scene& scene) : scene_(scene), is_removed_(scene.primitives.size()) {
    twins_.is_shown.assign(is_removed_.size(), true);
  }

  Twins run() {
    const int size = scene_.primitives.size();
    std::vector<std::pair<std::uint64_t, int>> order;
    order.reserve(is_removed_.size());
    for (int i = 0; i < size; ++i) order.emplace_back(hash_of_primitive(scene_.primitives, i), i);
    std::sort(order.begin(), order.end());
    for (auto first = order.begin(); first != order.end();) {
      const auto end = std::find_if(first, order.end(),
                                    [&](const auto& one) { return one.first != first->first; });
      if (end - first > 1) {
        std::vector<int> alike;
        for (auto i = first; i != end; ++i) alike.push_back(i->second);
        join(alike);
      }
      first = end;
    }
    if (twins_.equal + twins_.opposite > 0) compact();
    return std::move(twins_);
  }

 private:
  bool emits(int i) const { return !is_black(scene_.materials[scene_.material_of[i]].emission); }

  // Primitives in ascending order that have the same hash.
  void join(const std::vector<int>& alike) {
    std::vector<std::pair<int, Sides>> kept;
    for (const int i : alike) {
      const auto on = std::find_if(kept.begin(), kept.end(), [&](const auto& one) {
        return relation(scene_.primitives, one.first, i) != Relation::none;
      });
      if (on == kept.end()) {
        kept.emplace_back(i, Sides{i});
        continue;
      }
      const bool is_equal = relation(scene_.primitives, on->first, i) == Relation::equal;
      ++(is_equal ? twins_.equal : twins_.opposite);
      is_removed_[i] = true;
      show(is_equal ? on->second.front : on->second.back, i);
    }
    for (const auto& [primitive, sides] : kept) set_material(primitive, sides);
  }

  // Primitive i lies on this side, where another one may be shown.
  void show(int& side, int i) {
    if (side >= 0 && emits(side) && emits(i)) ++twins_.lamps;
    const bool is_seen = side < 0 || (emits(i) && !emits(side));
    if (is_seen && side >= 0) twins_.is_shown[side] = false;
    if (is_seen) side = i;
    if (!is_seen) twins_.is_shown[i] = false;
  }

  void set_material(int primitive, Sides sides) {
    const int front = scene_.material_of[sides.front];
    int& shown = material_of_.try_emplace(primitive, front).first->second;
    if (sides.back < 0) return;
    const int back = scene_.material_of[sides.back];
    if (back == front && !emits(sides.front)) return;
    const auto next = static_cast<int>(scene_.materials.size());
    const auto [pair, is_new] = pairs_.try_emplace({front, back}, next);
    if (is_new) {
      scene_.materials.push_back(scene_.materials[front]);
      scene_.materials.back().behind = back;
    }
    shown = pair->second;
  }

  void compact() {
    for (const auto& [primitive, material] : material_of_) {
      scene_.material_of[primitive] = material;
    }
    Primitives& all = scene_.primitives;
    Primitives left;
    std::vector<int> material_of;
    for (int i = 0; i < all.size(); ++i) {
      if (is_removed_[i]) continue;
      material_of.push_back(scene_.material_of[i]);
      if (all.is_triangle(i)) {
        left.triangles.push_back(all.triangle(i));
      } else {
        left.spheres.push_back(all.sphere(i));
      }
    }
    all = std::move(left);
    scene_.material_of = std::move(material_of);
  }

  Scene& scene_;
  Twins twins_;
  std::vector<bool> is_removed_;
  std::map<int, int> material_of_;  // of those that stay, set at the end
  std::map<std::pair<int, int>, int> pairs_;
};

double largest_coordinate(const Triangle& t) {
  return std::max({max_abs(t.p0), max_abs(t.p1), max_abs(t.p2)});
}

// The triangles whose planes come as near to the origin as another one's, at the same point to a
// millionth. Of a curved mesh that is hardly any.
std::vector<Triangle> in_shared_planes(const std::vector<Triangle>& triangles) {
  double largest = 0;
  for (const Triangle& t : triangles) largest = std::max(largest, largest_coordinate(t));
  const auto hash_of_plane = [&](const Triangle& t) {
    const Vec3 n = normalize(geometric_normal(t));
    const Vec3 nearest = (1e6 * dot(n, t.p0) / largest) * n;
    return hash_of({std::round(nearest.x), std::round(nearest.y), std::round(nearest.z)});
  };
  std::vector<std::pair<std::uint64_t, std::size_t>> planes;
  planes.reserve(triangles.size());
  for (const Triangle& t : triangles) planes.emplace_back(hash_of_plane(t), planes.size());
  std::sort(planes.begin(), planes.end());
  std::vector<Triangle> shared;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const bool as_before = i > 0 && planes[i - 1].first == planes[i].first;
    const bool as_next = i + 1 < planes.size() && planes[i + 1].first == planes[i].first;
    if (as_before || as_next) shared.push_back(triangles[planes[i].second]);
  }
  return shared;
}

}  // namespace

std::uint64_t hash_of(Vec3 p) {
  std::uint64_t hash = 0;
  // The first word of a sampler's state is its seed with all bits mixed.
  for (const double x : {p.x, p.y, p.z}) {
    hash = Sampler(hash + std::bit_cast<std::uint64_t>(x + 0.0)).state()[0];
  }
  return hash;
}

Twins merge_twins(Scene& scene) {
  share_diagonals(scene);
  return Merge(scene).run();
}

std::size_t count_overlaps(const Primitives& primitives) {
  constexpr std::size_t kMaxTested = 1'000'000;  // a larger file would take seconds longer
  constexpr double kApart = 1e-9;                // of the largest coordinate: not on purpose
  if (primitives.triangles.size() > kMaxTested) return 0;
  const Primitives candidates{in_shared_planes(primitives.triangles), {}};
  const WideBvh tree = WideBvh::build(candidates);
  std::size_t overlaps = 0;
  for (std::size_t i = 0; i < candidates.triangles.size(); ++i) {
    const Triangle& t = candidates.triangles[i];
    const Vec3 center = (t.p0 + t.p1 + t.p2) / 3, n = normalize(geometric_normal(t));
    const double apart = kApart * largest_coordinate(t);
    const Ray through{center - apart * n, n, 0, 2 * apart, static_cast<std::int64_t>(i)};
    overlaps += tree.closest(candidates, through) ? 1 : 0;
  }
  return overlaps;
}

}  // namespace pt
