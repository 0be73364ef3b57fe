// Ordinary inputs: a box of any place and size, also a flat one, and a ray that is aimed at it or passes beside it, from outside or
// inside, aslant or along an axis, with every kind of range.
#include "pt/tasks/hit_box.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <algorithm>
#include <cmath>

using namespace pt;
using namespace pt::inputs;

// The answer by cutting the range at the two planes of each axis.
static std::optional<Interval> expected(const Box& box, const Ray& ray) {
  double first = ray.t_min, last = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return std::nullopt;
      continue;
    }
    const double a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (first > last) return std::nullopt;
  return Interval{first, last};
}

static bool agree(const std::optional<Interval>& a, const std::optional<Interval>& b) {
  if (!a || !b) return !a && !b;
  const auto near = [](double x, double y) {
    return x == y || std::abs(x - y) <= 1e-6 * (1 + std::abs(y));
  };
  return near(a->min, b->min) && near(a->max, b->max);
}

static Vec3 scaled(Vec3 v, Vec3 by) { return {v.x * by.x, v.y * by.y, v.z * by.z}; }

EXAMPLE("less than 1 in 100 ordinary inputs differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 20000;
  for (int i = 0; i < kInputs; ++i) {
    Box box;
    const Vec3 center = 2 * any_vector(sampler);
    Vec3 half{0.1 + sampler.next_1d(), 0.1 + sampler.next_1d(), 0.1 + sampler.next_1d()};
    if (i % 11 == 0 && i % 9 != 0) half[i / 11 % 3] = 0;
    box.grow(center - half);
    box.grow(center + half);
    Ray ray;
    ray.origin =
        i % 4 != 0 ? 5 * any_vector(sampler) : center + 0.9 * scaled(half, any_vector(sampler));
    ray.direction = center + 1.3 * scaled(half, any_vector(sampler)) - ray.origin;
    if (i % 2 != 0) ray.direction = normalize(ray.direction);
    if (i % 9 == 0) {  // along an axis, aimed at the box
      const int axis = i / 9 % 3;
      const double away = ray.origin[axis];
      ray.origin = center + 1.2 * scaled(half, any_vector(sampler));
      ray.origin[axis] = away;
      ray.direction = {};
      ray.direction[axis] = center[axis] > away ? 1 : -1;
    }
    if (i % 5 == 0) ray.t_max = 4 * sampler.next_1d();
    if (i % 7 == 0) ray.t_min = 3 * sampler.next_1d();
    if (!agree(hit_box(box, ray), expected(box, ray))) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}
