#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/exact.h"
#include "grader/check/language/property.h"
#include "grader/tasks/hit_sphere/inputs.h"
#include "pt/tasks/hit_sphere.h"

namespace grader::check {
namespace {

using namespace hit_sphere_inputs;

// The distance of the point at t from the sphere, in radii. It follows from r^2 - R^2, which is exact.
double off_exactly(const pt::Sphere& sphere, const pt::Ray& ray, double t) {
  const Exact3 p = Exact3(ray.origin) + Exact(t) * Exact3(ray.direction) - Exact3(sphere.center);
  const Exact radius = sphere.radius;
  const double relative = rounded((dot(p, p) - radius * radius) / (radius * radius));
  return std::abs(relative) / (1 + std::sqrt(std::max(0.0, 1 + relative)));
}

double badness_of(const pt::Sphere& sphere, const pt::Ray& ray) {
  show_case(sphere, ray);
  const auto hit = pt::hit_sphere(sphere, ray);
  expect(hit.has_value(), "a hit", "no hit");
  const Exact3 p =
      Exact3(ray.origin) + Exact(hit->t) * Exact3(ray.direction) - Exact3(sphere.center);
  const double off_n = length(hit->n - normalize(rounded(p)));
  return std::max(off_exactly(sphere, ray, hit->t), off_n) / kPrecision;
}

SEARCH(hit_sphere, hits) {
  return {.title = "a ray at a sphere, from outside and inside, at most a thousand radii away",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const bool outside = *whole(0, 1) == 0;
            // Inside, a flatter chord has no room for the ray's origin.
            const Domain domain{
                .radius = 1e5, .speed = 1e9, .flat = outside ? 3e-4 : kFlat, .far = kFar};
            const Chord c = *chord(outside ? From::outside : From::inside, domain);
            return badness_of(c.sphere, c.ray);
          }};
}

SEARCH(hit_sphere, any_distance) {
  return {.title = "a ray at a sphere up to ten million radii away (a bonus)",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Aimed aimed = *aimed_from(1e3, 1e7);
            return badness_of(aimed.sphere, aimed.ray);
          }};
}

SEARCH(hit_sphere, beside) {
  return {.title = "a ray that passes a sphere: how far beside it hits",
          .measure = "1 is what the contract allows: 1e-8 radii",
          .badness = [] {
            constexpr double kAllowed = 1e-8;
            const Passing c = *passing(1e-10, 1e-7, kFar);
            show_case(c.sphere, c.ray);
            const Exact3 d = c.ray.direction, o = Exact3(c.ray.origin) - Exact3(c.sphere.center);
            const Exact3 m = cross(o, d);
            const Exact radius = c.sphere.radius;
            const double squared = rounded(dot(m, m) / (dot(d, d) * radius * radius) - 1);
            const double beside = squared / (1 + std::sqrt(1 + squared));
            const bool hit = pt::hit_sphere(c.sphere, c.ray).has_value();
            if (beside <= 0) return 0.0;
            return hit ? beside / kAllowed : 1e-3 / (1 + beside / kAllowed);
          }};
}

}  // namespace
}  // namespace grader::check
