#pragma once

#include "pt/math/vec3.h"

#include <cmath>
#include <vector>

// Closed forms for light.

namespace pt::proof {

using Polygon = std::vector<Vec3>;

inline Polygon parallelogram(Vec3 center, Vec3 u, Vec3 v) {
  return {center - 0.5 * u - 0.5 * v, center + 0.5 * u - 0.5 * v, center + 0.5 * u + 0.5 * v,
          center - 0.5 * u + 0.5 * v};
}

// The part of a convex polygon on the side of a plane to which n points (Sutherland and Hodgman
// 1974).
inline Polygon clipped(const Polygon& polygon, Vec3 on_plane, Vec3 n) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double height_a = dot(a - on_plane, n), height_b = dot(b - on_plane, n);
    if (height_a >= 0) kept.push_back(a);
    if ((height_a < 0) != (height_b < 0)) {
      kept.push_back(a + height_a / (height_a - height_b) * (b - a));
    }
  }
  return kept;
}

inline double angle(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// The irradiance at p on a surface with normal n from a polygon of radiance 1, clipped at the
// horizon (Lambert 1760): half the sum, over the edges, of the angle the edge fills times the
// cosine between n and the normal of the plane through p and the edge.
inline double lambert_irradiance(Vec3 p, Vec3 n, const Polygon& light) {
  const Polygon polygon = clipped(light, p, n);
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
    const Vec3 normal = cross(a, b);
    if (length(normal) > 0) sum += angle(a, b) * dot(n, normalize(normal));
  }
  return 0.5 * std::abs(sum);
}

// The solid angle of a triangle seen from p (Van Oosterom and Strackee 1983).
inline double solid_angle(Vec3 p, Vec3 p0, Vec3 p1, Vec3 p2) {
  const Vec3 a = normalize(p0 - p), b = normalize(p1 - p), c = normalize(p2 - p);
  return 2 * std::abs(std::atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a)));
}

// The irradiance from a sphere of radiance 1 and radius 1 at distance h, on a surface whose normal
// leans by `tilt` from the direction of the centre: pi cos(tilt) / h^2 while the whole sphere is
// above the horizon, and the form of Naraghi 1988 (Howell's catalogue of configuration factors)
// where the horizon cuts it.
inline double sphere_irradiance(double h, double tilt) {
  const double half_angle = std::asin(1 / h);
  if (tilt + half_angle <= kPi / 2) return kPi * std::cos(tilt) / (h * h);
  if (tilt - half_angle >= kPi / 2) return 0;
  const double root = std::sqrt(h * h - 1);
  const double cosine = std::cos(tilt), sine = std::sin(tilt);
  return kPi / 2 - std::asin(root / (h * sine)) +
         (cosine * std::acos(-root * cosine / sine) -
          root * std::sqrt(1 - h * h * cosine * cosine)) /
             (h * h);
}

}  // namespace pt::proof
