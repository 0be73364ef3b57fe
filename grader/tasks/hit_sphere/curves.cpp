#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/hit_sphere/inputs.h"
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace hit_sphere_inputs;

double t_of_hit(const pt::Sphere& sphere, const pt::Ray& ray) {
  const auto hit = pt::hit_sphere(sphere, ray);
  expect(hit.has_value(), "a hit", "no hit");
  return hit->t;
}

std::vector<Method> methods() {
  return {{"methods/quadratic", "quadratic formula"},
          {"methods/distance_to_the_ray", "distance to the ray"},
          {"methods/quadratic", "quadratic formula, single precision", true},
          {"methods/distance_to_the_ray", "distance to the ray, single precision", true}};
}

CURVE(hit_sphere, far_away) {
  return {.title = "A sphere that is far away",
          .input = "distance of the origin, in radii",
          .error = "distance of the point from the sphere, in radii",
          .source = "Haines, Guenther and Akenine-Moeller 2019, Ray Tracing Gems, chapter 7",
          .places = by_factors(1, 1e9, 19),
          .promised = {{1, 1e3, at_most(kPrecision)}, {1, 1e7, at_most(kPrecision), true}},
          .methods = methods(),
          .measure = [](double distance) {
            const Aimed aimed = *aimed_from(distance, distance);
            return off_the_sphere(aimed, t_of_hit(aimed.sphere, aimed.ray));
          }};
}

CURVE(hit_sphere, huge) {
  return {
      .title = "A ground that is a huge sphere, seen from one unit above it",
      .input = "radius, in heights of the origin",
      .error = "relative error of t",
      .source = "Haines, Guenther and Akenine-Moeller 2019, Ray Tracing Gems, chapter 7",
      .places = by_factors(1e3, 1e12, 19),
      // A height of the point of a millionth of the radius. Along the ray, this is longer by the
      // ratio of t to the height of the origin.
      .promised = {{1e3, 1e6, [](double radius) { return kPrecision * radius; }}},
      .methods = methods(),
      .measure = [](double radius) {
        const Ground c = *ground(radius);
        return std::abs(t_of_hit(c.sphere, c.ray) / c.t - 1);
      }};
}

}  // namespace
}  // namespace grader::check
