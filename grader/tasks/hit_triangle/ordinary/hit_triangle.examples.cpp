// Ordinary inputs: a triangle of any shape and place, with corner normals that differ, and a ray that is aimed at it or passes beside
// it, from either side, with directions of about any length and every kind of range.
#include "pt/tasks/hit_triangle.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <cmath>

using namespace pt;
using namespace pt::inputs;

static bool agree(const std::optional<SurfaceHit>& a, const std::optional<SurfaceHit>& b) {
  if (!a || !b) return !a && !b;
  return std::abs(a->t - b->t) <= 1e-6 * (1 + std::abs(b->t)) && length(a->n - b->n) <= 1e-4;
}

EXAMPLE("less than 1 in 100 ordinary inputs differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 20000;
  for (int i = 0; i < kInputs; ++i) {
    const Vec3 a = 2 * any_vector(sampler), b = 2 * any_vector(sampler),
               c = 2 * any_vector(sampler);
    const Vec3 face = (i % 2 == 0 ? 1 : -1) * normalize(cross(b - a, c - a));
    const auto corner = [&] { return normalize(face + 0.5 * any_vector(sampler)); };
    const Triangle triangle{a, b, c, corner(), corner(), corner()};
    const double wb = any_number(sampler, -0.2, 1), wc = any_number(sampler, -0.2, 1);
    const double wa = 1 - wb - wc;
    Ray ray;
    ray.origin = 5 * any_vector(sampler);
    ray.direction = wa * a + wb * b + wc * c - ray.origin;
    double t = 1;
    if (i % 3 != 0) {
      t = length(ray.direction);
      ray.direction = ray.direction / t;
    }
    if (i % 5 == 0) ray.t_max = any_number(sampler, 0, 2 * t);
    if (i % 7 == 0) ray.t_min = any_number(sampler, 0, 2 * t);
    std::optional<SurfaceHit> expected;
    if (wa > 0 && wb > 0 && wc > 0 && t >= ray.t_min && t <= ray.t_max)
      expected = {t, normalize(wa * triangle.n0 + wb * triangle.n1 + wc * triangle.n2)};
    if (!agree(hit_triangle(triangle, ray), expected)) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}
