#pragma once

#include "grader/check/mocks/counting.h"
#include "grader/mistakes/battery.h"
#include "grader/tasks/hit_bvh/trees.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

// The answers of queries: the hit, and which rules on the cost were broken. The order in which a
// tree is walked is free, so the number of tests is not part of an answer.

namespace grader::mistakes {

using check::Tested, check::tested, check::forget_tests;
using check::hit_bvh_inputs::Case;

using Name = std::tuple<double, double, double, double>;
inline Name name_of(const pt::Box& b) { return {b.min.x, b.min.y, b.max.x, b.max.z}; }
inline Name name_of(const pt::Triangle& t) { return {t.p0.x, t.p0.y, t.p1.x, t.p1.y}; }
inline Name name_of(const pt::Sphere& s) { return {s.center.x, s.center.y, s.center.z, s.radius}; }

// Returns whether something was tested more often than it occurs in the tree. Boxes may be equal.
template <class T>
bool too_often(const std::vector<T>& asked, const std::vector<T>& there) {
  std::map<Name, int> left;
  for (const T& each : there) ++left[name_of(each)];
  return std::ranges::any_of(asked, [&](const T& each) { return --left[name_of(each)] < 0; });
}

inline std::vector<pt::Box> boxes_of(const pt::Bvh& bvh) {
  std::vector<pt::Box> boxes;
  for (const pt::BvhNode& node : bvh.nodes) boxes.push_back(node.box);
  return boxes;
}

template <class T>
bool was_asked(const std::vector<T>& asked, const T& about) {
  return std::ranges::any_of(asked, [&](const T& one) { return name_of(one) == name_of(about); });
}

inline bool was_asked(const Tested& log, const pt::Primitives& primitives, int i) {
  return primitives.is_triangle(i) ? was_asked(log.triangles, primitives.triangle(i))
                                   : was_asked(log.spheres, primitives.sphere(i));
}

struct Cost {
  double box_twice = 0, primitive_twice = 0, primitive_outside = 0, box_outside = 0;
};

inline Cost cost_of(const Case& c, const Tested& log) {
  Cost cost;
  cost.box_twice = flag(too_often(log.boxes, boxes_of(c.bvh)));
  cost.primitive_twice = flag(too_often(log.triangles, c.primitives.triangles) ||
                              too_often(log.spheres, c.primitives.spheres));
  for (const pt::BvhNode& node : c.bvh.nodes) {
    if (c.bvh.nodes.size() == 1 || pt::hit_box(node.box, c.ray)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (was_asked(log, c.primitives, c.bvh.order[i])) cost.primitive_outside = 1;
    }
    if (node.is_leaf()) continue;
    for (const int child : {node.left, node.right}) {
      const pt::Box& box = c.bvh.nodes[child].box;
      if (name_of(box) == name_of(node.box)) continue;  // the log cannot distinguish them
      if (was_asked(log.boxes, box)) cost.box_outside = 1;
    }
  }
  return cost;
}

// The cost is found with hit_box, which adds to the record.
inline Tested copy_of_tests() { return tested(); }

// Each query starts with an empty record, so that it contains no test of the query before.
inline Battery::Numbers look(const Case& c, bool with_cost) {
  forget_tests();
  const auto hit = pt::hit_bvh(c.bvh, c.primitives, c.ray);
  const Tested log = copy_of_tests();
  Battery::Numbers all{flag(hit.has_value())};
  if (hit) all.insert(all.end(), {hit->t, hit->n.x, hit->n.y, hit->n.z, 1.0 * hit->primitive});
  if (!with_cost) return all;
  const Cost cost = cost_of(c, log);
  all.insert(all.end(),
             {cost.box_twice, cost.primitive_twice, cost.primitive_outside, cost.box_outside});
  return all;
}

inline Battery::Numbers look_for_any(const Case& c, bool with_cost) {
  forget_tests();
  const bool occluded = pt::occluded_bvh(c.bvh, c.primitives, c.ray);
  const Tested log = copy_of_tests();
  Battery::Numbers all{flag(occluded)};
  if (!with_cost) return all;
  const Cost cost = cost_of(c, log);
  bool stopped = true;
  for (std::size_t i = 0; i + 1 < log.triangles.size(); ++i) {
    stopped = stopped && !pt::hit_triangle(log.triangles[i], c.ray);
  }
  all.insert(all.end(), {cost.box_twice, cost.primitive_twice, cost.primitive_outside,
                         cost.box_outside, flag(stopped)});
  return all;
}

}  // namespace grader::mistakes
