#include "grader/check/language/curve.h"
#include "grader/tasks/build_bvh/invariants.h"
#include "pt/geometry/ray.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace build_bvh_inputs;

std::vector<Method> splits() {
  return {{"wrong/midpoint", "middle of the longest axis"},
          {"right/median", "median"},
          {"right/swept_surface_area", "surface area heuristic"}};
}

double depth_of(const Input& input) { return depth(built(input.boxes, 1)); }

CURVE(build_bvh, halving) {
  return {.title = "Points, each half as far from the first corner as the one before",
          .input = "boxes",
          .error = "levels of the tree",
          .source = "a plane in the middle cuts off one box",
          .places = {10, 20, 40, 70, 100, 140, 200, 300, 550, 1000},
          .promised = {{100, 300, [](double n) { return std::floor(4 * std::log2(n)); }, true}},
          .methods = splits(),
          .cases = 3,
          .measure = [](double boxes) {
            return depth_of(halving_points(*whole(0, 2), static_cast<int>(boxes)));
          }};
}

CURVE(build_bvh, identical) {
  return {.title = "Identical boxes",
          .input = "boxes",
          .error = "levels of the tree",
          .source = "no plane separates them: a split that does not notice never ends",
          .places = {10, 30, 100, 300, 1000, 3000},
          // The contract requires an end. No tree of n leaves has more levels than n - 1.
          .promised = {{10, 3000, [](double n) { return n - 1; }}},
          .methods = {{"right/median", "median"},
                      {"right/swept_surface_area", "surface area heuristic"},
                      {"wrong/no_fallback", "middle, again and again"},
                      {"wrong/tries_for_ever", "the same plane, for ever"}},
          .cases = 3,
          .measure = [](double boxes) {
            const int n = static_cast<int>(boxes);
            return depth_of(*boxes_of({Kind::identical}, n, n));
          }};
}

// Returns whether a line through the point meets the box, a little enlarged.
bool meets(const pt::Box& box, pt::Vec3 p, pt::Vec3 d) {
  double enter = -pt::kInfinity, leave = pt::kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min[axis] - p[axis]) / d[axis], b = (box.max[axis] - p[axis]) / d[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave + 1e-9;
}

// Boxes and primitives that a line tests if no hit ends the search.
double tests_of_a_line(const pt::Bvh& bvh, pt::Vec3 p, pt::Vec3 d) {
  int tests = 1;
  std::vector<int> open{0};
  while (!open.empty()) {
    const pt::BvhNode& node = bvh.nodes[open.back()];
    open.pop_back();
    if (!meets(node.box, p, d)) continue;
    tests += node.is_leaf() ? node.count : 2;
    if (has_children(node)) open.insert(open.end(), {node.left, node.right});
  }
  return tests;
}

double tests_of_a_line(const std::vector<pt::Box>& boxes) {
  constexpr int kLines = 200;
  const pt::Bvh bvh = built(boxes, 1);
  expect_nodes(bvh);
  expect_one_tree(bvh);
  RandomNumbers make(*sampler_seed());
  double sum = 0;
  for (int i = 0; i < kLines; ++i) {
    const pt::Vec3 p = make.vector(-1, 1), q = make.vector(-1, 1);
    sum += tests_of_a_line(bvh, p, q - p) / kLines;
  }
  return sum;
}

// Small boxes on a sphere, like those of its triangles, and the six walls of a room around it.
std::vector<pt::Box> sphere_in_a_room(int n) {
  RandomNumbers make(*sampler_seed());
  std::vector<pt::Box> boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      pt::Vec3 half{1, 1, 1};
      half[axis] = 0;
      boxes.push_back(around(on_axis(axis, side), half));
    }
  }
  const double size = 1 / std::sqrt(n);
  while (static_cast<int>(boxes.size()) < n) {
    const pt::Vec3 p = make.vector(-1, 1);
    if (!(length(p) > 0.1 && length(p) < 1)) continue;
    const pt::Vec3 half = size * make.vector(0.2, 1);
    boxes.push_back(around(0.6 * normalize(p), half));
  }
  make.shuffle(boxes);
  return boxes;
}

CURVE(build_bvh, tests_per_line) {
  return {.title = "A sphere of small triangles in a room",
          .input = "boxes",
          .error = "boxes and primitives that a line tests",
          .source = "an axis or an order that has nothing to do with where the boxes are",
          .places = {30, 100, 300, 1000, 3000, 10000},
          .promised = {},
          .methods = {{"right/median", "median"},
                      {"right/swept_surface_area", "surface area heuristic"},
                      {"wrong/shortest_axis", "middle of the shortest axis"},
                      {"wrong/halves_in_the_given_order", "halves, in the given order"}},
          .statistic = Statistic::median,
          .cases = 3,
          .measure = [](double boxes) {
            return tests_of_a_line(sphere_in_a_room(static_cast<int>(boxes)));
          }};
}

// A long thin triangle along a diagonal has a box that is mostly empty, and meets all others.
CURVE(build_bvh, slivers) {
  return {.title = "A thousand boxes that overlap, as those of long thin triangles",
          .input = "side of a box, in sizes of the scene",
          .error = "boxes and primitives that a line tests",
          .source = "no order of whole boxes separates what overlaps",
          .places = by_factors(1e-3, 1, 10),
          .promised = {},
          .methods = {{"right/median", "median"},
                      {"right/swept_surface_area", "surface area heuristic"},
                      {"wrong/halves_in_the_given_order", "halves, in the given order"}},
          .statistic = Statistic::median,
          .cases = 3,
          .measure = [](double side) {
            RandomNumbers make(*sampler_seed());
            std::vector<pt::Box> boxes;
            boxes.reserve(1000);
            for (int i = 0; i < 1000; ++i) {
              boxes.push_back(around((1 - side) * make.vector(-1, 1), {side, side, side}));
            }
            return tests_of_a_line(boxes);
          }};
}

}  // namespace
}  // namespace grader::check
