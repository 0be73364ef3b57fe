#pragma once

#include "grader/check/language/exact.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"

#include <algorithm>
#include <cmath>

// Where the line of a ray meets a sphere, and how far an answer is off: the oracle for spheres and rays of which nothing is
// known. No difference here loses digits.

namespace grader::check::hit_sphere_inputs {

// 1 less the square of the line's distance from the centre, in radii: negative if it passes beside the sphere.
inline Exact depth(const pt::Sphere& sphere, const pt::Ray& ray) {
  const Exact3 d = ray.direction, beside = cross(Exact3(ray.origin) - Exact3(sphere.center), d);
  return 1 - dot(beside, beside) / (dot(d, d) * Exact(sphere.radius) * Exact(sphere.radius));
}

// The first point in front of the origin.
inline Exact t_in_front(const pt::Sphere& sphere, const pt::Ray& ray) {
  const Exact3 d = ray.direction;
  const Exact middle = dot(Exact3(sphere.center) - Exact3(ray.origin), d) / dot(d, d);
  const Exact half = sphere.radius * root(depth(sphere, ray)) / length(d);
  return middle > half ? middle - half : middle + half;
}

// The errors of the point and of the normal of an answer, in radii.
struct Off {
  double point, normal;
};

inline Off off(const pt::Sphere& sphere, const pt::Ray& ray, const pt::SurfaceHit& hit) {
  const Exact3 p =
      Exact3(ray.origin) + Exact(hit.t) * Exact3(ray.direction) - Exact3(sphere.center);
  const Exact radius = sphere.radius;
  const double relative = rounded((dot(p, p) - radius * radius) / (radius * radius));
  return {std::abs(relative) / (1 + std::sqrt(std::max(0.0, 1 + relative))),
          static_cast<double>(length(Exact3(hit.n) - normalize(p)))};
}

}  // namespace grader::check::hit_sphere_inputs
