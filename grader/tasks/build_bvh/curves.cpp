#include "grader/check/curve.h"
#include "grader/tasks/build_bvh/walk.h"

namespace grader::check {
namespace {

using namespace build_bvh_cases;

std::vector<Method> splits() {
  return {{"wrong/midpoint", "middle of the longest axis"},
          {"right/median", "median"},
          {"right/swept_surface_area", "surface area heuristic"}};
}

double depth_of(Kind kind, double boxes) {
  const int n = static_cast<int>(boxes);
  Input input = *boxes_of({kind}, n, n);
  input.max_leaf = 1;
  return depth(pt::build_bvh(input.boxes, input.max_leaf));
}

CURVE(build_bvh, halving) {
  return {.title = "Points, each half as far from the first corner as the one before",
          .input = "boxes",
          .error = "levels of the tree",
          .source = "a plane in the middle cuts off one box",
          .places = {10, 20, 40, 80, 160, 320, 640, 1000},
          .promised = {},
          .methods = splits(),
          .cases = 3,
          .measure = [](double boxes) { return depth_of(Kind::halving, boxes); }};
}

CURVE(build_bvh, identical) {
  return {.title = "Identical boxes",
          .input = "boxes",
          .error = "levels of the tree",
          .source = "no plane separates them: a split that does not notice never ends",
          .places = {10, 30, 100, 300, 1000, 3000},
          .promised = {},
          .methods = splits(),
          .cases = 3,
          .measure = [](double boxes) { return depth_of(Kind::identical, boxes); }};
}

}  // namespace
}  // namespace grader::check
