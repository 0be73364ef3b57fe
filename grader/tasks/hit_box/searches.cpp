#include "grader/check/search.h"
#include "grader/tasks/hit_box/cases.h"
#include "pt/tasks/hit_box.h"

#include <sstream>

namespace grader::check {
namespace {

using namespace hit_box_cases;

void show_case(const Case& c) {
  show_input([&] {
    std::ostringstream out;
    show_lines(out, c.box, c.ray);
    return out.str();
  });
}

// How far an end is from the right one, where 1 is what the contract allows. An end of the ray's own
// range is exact.
double off(double got, const Ends& right, const pt::Ray& ray) {
  if (got == ray.t_min || got == ray.t_max)
    return got < right.low || got > right.high ? kBroken : 0;
  const long double middle = (right.low + right.high) / 2, half = (right.high - right.low) / 2;
  const long double error = std::abs(got - middle);
  return static_cast<double>(error == 0 ? 0 : error / half);
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
            return std::max(off(hit->min, part.enter, c.ray), off(hit->max, part.leave, c.ray));
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
