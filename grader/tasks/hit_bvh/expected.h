#pragma once

#include "grader/check/language/property.h"
#include "grader/tasks/hit_bvh/queries.h"
#include "grader/tasks/hit_bvh/truth.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <string>
#include <vector>

// Compares the answers of queries with those of testing every primitive in turn.

namespace grader::check::hit_bvh_inputs {

// Judges t of the nearest hit, in a case with a hit.
inline void expect_nearest(const Case& c) {
  const Truth truth = truth_of(c);
  if (!truth.any() || !truth.is_clear) return;
  const auto hit = ask(c);
  expect(hit.has_value(), shown(truth), "no hit");
  expect_near("t of the nearest hit", hit->t, truth.t(), t_error(truth));
}

// Judges whether there is a hit, and its t if there is one.
inline void expect_as_all(const Case& c) {
  const Truth truth = truth_of(c);
  if (!truth.is_clear) return;
  const auto hit = ask(c);
  expect(hit.has_value() == truth.any(), shown(truth), shown(hit));
  if (hit) expect_near("t of the nearest hit", hit->t, truth.t(), t_error(truth));
}

inline void expect_occluded_as_all(const Case& c) {
  const Truth truth = truth_of(c);
  if (!truth.is_clear) return;
  const bool occluded = occluded_bvh(c.bvh, c.primitives, c.ray);
  expect(occluded == truth.any(), "in the way: " + shown(truth),
         occluded ? "something in the way" : "nothing in the way");
}

// A wall at which the ray's range begins or ends is a hit, if the judge's hit_triangle answers.
// Within the precision of its contract, the submission's own may answer otherwise.
inline void expect_nearest_at_an_end(const Case& c) {
  if (!judge_answers) return;
  const Truth truth = truth_of(c);
  const auto hit = ask(c);
  expect(hit.has_value(), shown(truth) + ": a range has both its ends", "no hit");
  expect_near("t of the nearest hit", hit->t, truth.t(), t_error(truth));
}

inline void expect_occluded_at_an_end(const Case& c) {
  if (!judge_answers) return;
  expect(pt::occluded_bvh(c.bvh, c.primitives, c.ray),
         "in the way: " + shown(truth_of(c)) + ": a range has both its ends", "nothing in the way");
}

// Compares the tests that a query made with the tree.

inline bool same(const pt::Box& a, const pt::Box& b) { return a.min == b.min && a.max == b.max; }
inline bool same(const pt::Sphere& a, const pt::Sphere& b) { return a.center == b.center; }
inline bool same(const pt::Triangle& a, const pt::Triangle& b) {
  return a.p0 == b.p0 && a.p1 == b.p1;
}

template <class T>
long long times(const std::vector<T>& asked, const T& about) {
  return std::ranges::count_if(asked, [&](const T& one) { return same(one, about); });
}

inline long long times_asked(const Tested& log, const pt::Primitives& primitives, int i) {
  return primitives.is_triangle(i) ? times(log.triangles, primitives.triangle(i))
                                   : times(log.spheres, primitives.sphere(i));
}

// Returns whether the ray clearly misses the box. For a right hit_box, the box may be larger by
// some rounding errors (pt/tasks/hit_box.h: 1e-12 of the largest coordinate).
inline bool is_missed(pt::Box box, const pt::Ray& ray) {
  const double size = std::max({max_abs(box.min), max_abs(box.max), max_abs(ray.origin)});
  const double more = 1e-11 * size;
  box.min -= {more, more, more};
  box.max += {more, more, more};
  // The range is made longer too, since a computed t_max may be a little larger.
  pt::Ray longer = ray;
  longer.t_min *= 1 - 1e-11;
  longer.t_max *= 1 + 1e-11;
  return !pt::hit_box(box, longer);
}

// Says why the ray misses the box: it may only end before it or begin behind it.
inline std::string how_missed(const std::string& name, const pt::Box& box, const pt::Ray& ray) {
  const auto on_line = pt::hit_box(box, {ray.origin, ray.direction});
  if (on_line && on_line->min > ray.t_max) {
    return "the ray ends at t " + brief(ray.t_max) + ", before " + name + " begins at t " +
           brief(on_line->min);
  }
  if (on_line && on_line->max < ray.t_min) {
    return "the ray begins at t " + brief(ray.t_min) + ", behind " + name + ", which ends at t " +
           brief(on_line->max);
  }
  return "the ray misses " + name;
}

inline std::string tests_by(bool any, long long count) {
  return std::to_string(count) + (count == 1 ? " test" : " tests") +
         (any ? ", by occluded_bvh" : ", by hit_bvh");
}

inline void expect_few_tests(const Case& c, const Tested& log) {
  const auto asked = std::ssize(log.triangles) + std::ssize(log.spheres);
  expect(2 * asked < c.primitives.size(),
         "tests of fewer than half of the " + std::to_string(c.primitives.size()) +
             " primitives: the ray enters the boxes of few",
         std::to_string(asked));
  expect(2 * std::ssize(log.boxes) < std::ssize(c.bvh.nodes),
         "tests of fewer than half of the " + std::to_string(c.bvh.nodes.size()) +
             " boxes: nothing below a box is tested that the ray does not enter",
         std::to_string(log.boxes.size()));
}

inline void expect_only_entered_leaves(const Case& c, bool any) {
  const Tested log = tested_by(c, any);
  // In a tree of one leaf, no test of a box is necessary.
  if (c.bvh.nodes.size() == 1) return;
  for (const pt::BvhNode& node : c.bvh.nodes) {
    if (!node.is_leaf() || !is_missed(node.box, c.ray)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = c.bvh.order[i];
      const long long asked = times_asked(log, c.primitives, primitive);
      expect(asked == 0,
             "no test of primitive " + std::to_string(primitive) + ": " +
                 how_missed("the box of its leaf", node.box, c.ray),
             tests_by(any, asked));
    }
  }
}

inline void expect_only_boxes_below_entered_ones(const Case& c, bool any) {
  const Tested log = tested_by(c, any);
  for (std::size_t i = 0; i < c.bvh.nodes.size(); ++i) {
    const pt::BvhNode& node = c.bvh.nodes[i];
    if (node.is_leaf() || !is_missed(node.box, c.ray)) continue;
    for (const int child : {node.left, node.right}) {
      const pt::Box& box = c.bvh.nodes[child].box;
      if (same(box, node.box)) continue;  // the log cannot distinguish them
      const long long asked = times(log.boxes, box);
      expect(asked == 0,
             "no test of the box of node " + std::to_string(child) + ": " +
                 how_missed("the box of its parent, node " + std::to_string(i), node.box, c.ray),
             tests_by(any, asked));
    }
  }
}

inline void expect_no_test_twice(const Case& c, bool any) {
  const Tested log = tested_by(c, any);
  for (std::size_t i = 0; i < c.bvh.nodes.size(); ++i) {
    const pt::Box& box = c.bvh.nodes[i].box;
    const long long equal = std::ranges::count_if(
        c.bvh.nodes, [&](const pt::BvhNode& node) { return same(node.box, box); });
    const long long asked = times(log.boxes, box);
    expect(asked <= equal, "at most one test of the box of node " + std::to_string(i),
           tests_by(any, asked));
  }
  for (int i = 0; i < c.primitives.size(); ++i) {
    const long long asked = times_asked(log, c.primitives, i);
    expect(asked <= 1, "at most one test of primitive " + std::to_string(i), tests_by(any, asked));
  }
}

}  // namespace grader::check::hit_bvh_inputs
