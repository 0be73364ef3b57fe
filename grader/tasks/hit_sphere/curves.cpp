#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/hit_sphere/inputs.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace hit_sphere_inputs;

pt::SurfaceHit hit_of(const Chord& c) {
  const auto hit = call(c);
  expect(hit.has_value(), "a hit", "no hit");
  return *hit;
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
            const Chord c = *aimed_from(distance, distance);
            return off(c, hit_of(c)).point;
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
        const Chord c = *ground(radius);
        return std::abs(hit_of(c).t / c.t_near - 1);
      }};
}

// A ray that passes the edge of the sphere at this distance, half of them outside.
CURVE(hit_sphere, silhouette) {
  return {.title = "Rays along the edge of a sphere",
          .input = "distance of the ray from the edge, in radii",
          .error = "share of rays that miss inside the edge, or hit outside",
          .source = "the discriminant is a difference of nearly equal numbers",
          .places = by_factors(0.1, 1e-15, 15),
          .promised = {{0.1, kTouching}},
          .methods = methods(),
          .statistic = Statistic::mean,
          .measure = [](double beside) {
            const bool is_inside = *rc::gen::arbitrary<bool>();
            const double half = is_inside ? std::sqrt(beside * (2 - beside)) : 0;
            const Chord c = line_at({{}, 1}, *any_frame(), is_inside ? 1 - beside : 1 + beside,
                                    half, *magnitude(0.1, 100), 1);
            return call(c).has_value() == is_inside ? 0 : 1;
          }};
}

}  // namespace
}  // namespace grader::check
