#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/exact.h"
#include "grader/tasks/hit_box/exact.h"
#include "pt/tasks/hit_box.h"

namespace grader::check {
namespace {

using namespace hit_box_inputs;

// The interval in arithmetic of 113 bits. In these cases, no ray is parallel to a slab and outside
// it.
struct Inside {
  Exact enter, leave;
};

Inside exactly(const Case& c) {
  Inside inside{c.ray.t_min, c.ray.t_max};
  for (int axis = 0; axis < 3; ++axis) {
    const Exact o = c.ray.origin[axis], d = c.ray.direction[axis];
    if (d == 0) continue;
    const Exact a = (c.box.min[axis] - o) / d, b = (c.box.max[axis] - o) / d;
    inside.enter = std::max(inside.enter, std::min(a, b));
    inside.leave = std::min(inside.leave, std::max(a, b));
  }
  return inside;
}

// The error of an end, where 1 is what the contract allows on that side.
double off(double got, Exact right, const Ends& allowed) {
  const double error = rounded(Exact(got) - right);
  if (error == 0) return 0;
  const Exact end = error < 0 ? allowed.low : allowed.high;
  return error / rounded(end - right);
}

Case any_case() {
  const Extreme extreme = *rc::gen::element(Extreme::none, Extreme::scale, Extreme::length);
  switch (*whole(0, 3)) {
    case 0:
      return *aimed_at_a_side(extreme);
    case 1:
      return *starting_inside();
    case 2:
      return *along_axes(false);
    default:
      return *aimed_inside(extreme);
  }
}

SEARCH(hit_box, ends) {
  return {.title = "a ray at a point in a box: how far the ends of the interval are off",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Case c = any_case();
            show_case(c);
            const Part part = expected(c.box, c.ray);
            const auto hit = pt::hit_box(c.box, c.ray);
            if (!hit) return part.is_hit() ? kBroken : 0;
            if (part.is_miss()) return kBroken;
            const Inside right = exactly(c);
            return std::max(off(hit->min, right.enter, part.enter),
                            off(hit->max, right.leave, part.leave));
          }};
}

SEARCH(hit_box, grazing) {
  return {.title = "a ray exactly at an edge or a corner of the box of a triangle (a bonus)",
          .measure = "1 is an interval without length, and a miss is broken",
          .badness = [] {
            const Case c = *grazing(*rc::gen::element(0.0, 1e3, 1e6, 1e9));
            show_case(c);
            const auto hit = pt::hit_box(c.box, c.ray);
            if (!hit) return kBroken;
            return 1 / (1 + (hit->max - hit->min) / (std::abs(hit->max) * 0x1p-53));
          }};
}

}  // namespace
}  // namespace grader::check
