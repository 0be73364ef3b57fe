// Ordinary inputs: a sphere of any place and size, and a ray that is aimed at it or passes beside it, from outside or inside, with
// directions of about any length and every kind of range.
#include "pt/tasks/hit_sphere.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <cmath>

using namespace pt;
using namespace pt::inputs;

// The answer by the distance between the centre and the line.
static std::optional<SurfaceHit> expected(const Sphere& sphere, const Ray& ray) {
  const double speed = length(ray.direction);
  const Vec3 d = ray.direction / speed;
  const double middle = dot(sphere.center - ray.origin, d);
  const double beside = length(ray.origin + middle * d - sphere.center);
  if (!(beside < sphere.radius)) return std::nullopt;
  const double half = std::sqrt(sphere.radius * sphere.radius - beside * beside);
  for (const double t : {(middle - half) / speed, (middle + half) / speed}) {
    if (t >= ray.t_min && t <= ray.t_max)
      return SurfaceHit{t, (ray.at(t) - sphere.center) / sphere.radius};
  }
  return std::nullopt;
}

static bool agree(const std::optional<SurfaceHit>& a, const std::optional<SurfaceHit>& b) {
  if (!a || !b) return !a && !b;
  return std::abs(a->t - b->t) <= 1e-4 * (1 + std::abs(b->t)) && length(a->n - b->n) <= 1e-4;
}

EXAMPLE("less than 1 in 100 ordinary inputs differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 20000;
  for (int i = 0; i < kInputs; ++i) {
    const Sphere sphere{2 * any_vector(sampler), 0.2 + 0.8 * sampler.next_1d()};
    Ray ray;
    ray.origin = i % 4 != 0 ? 4 * any_vector(sampler)
                            : sphere.center + 0.5 * sphere.radius * any_vector(sampler);
    ray.direction = sphere.center + 1.2 * sphere.radius * any_vector(sampler) - ray.origin;
    if (i % 2 != 0) ray.direction = normalize(ray.direction);
    if (i % 5 == 0) ray.t_max = 4 * sampler.next_1d();
    if (i % 7 == 0) ray.t_min = 3 * sampler.next_1d();
    if (!agree(hit_sphere(sphere, ray), expected(sphere, ray))) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}
