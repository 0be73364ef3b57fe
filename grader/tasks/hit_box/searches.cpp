#include "grader/check/language/bad_inputs.h"
#include "grader/tasks/hit_box/exact.h"

namespace grader::check {
namespace {

using namespace hit_box_inputs;

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
            const Part part = expected(c);
            const auto hit = call(c);
            if (!hit) return part.is_hit() ? kBroken : 0;
            if (part.is_miss()) return kBroken;
            return off(c.box, c.ray, *hit);
          }};
}

SEARCH(hit_box, grazing) {
  return {.title = "a ray exactly at an edge or a corner of the box of a triangle (a bonus)",
          .measure = "1 is an interval without length, and a miss is broken",
          .badness = [] {
            const Case c = *grazing(*rc::gen::element(0.0, 1e3, 1e6, 1e9));
            show_case(c);
            const auto hit = call(c);
            if (!hit) return kBroken;
            return 1 / (1 + (hit->max - hit->min) / (std::abs(hit->max) * 0x1p-53));
          }};
}

}  // namespace
}  // namespace grader::check
