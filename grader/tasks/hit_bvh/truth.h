#pragma once

#include "grader/check/language/show.h"
#include "grader/tasks/hit_bvh/trees.h"
#include "pt/geometry/primitives.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

// The right hits of a ray, and the allowed differences of right versions of hit_triangle and
// hit_sphere. If a submission is judged together with its own tasks, those answer hit_bvh, to the
// precision of their contracts. If hit_bvh is judged alone, the judge's tasks answer, and hit_bvh
// has to return their answers unchanged.

namespace grader::check::hit_bvh_inputs {

// The result for one primitive and one ray.
struct Meeting {
  std::optional<pt::SurfaceHit> hit;
  double t_error = 0;    // of a right answer of hit_triangle or hit_sphere
  double n_error = 0;    // likewise
  bool is_clear = true;  // all right answers agree whether it is a hit
};

// Right answers may disagree near the ends of a ray's range and near edges. Cases that are within
// this many times the contract's error of such a place are not used.
inline constexpr double kMargin = 4;

inline bool is_near_an_end(double t, double error, const pt::Ray& ray) {
  return std::abs(t - ray.t_min) <= kMargin * error || std::abs(t - ray.t_max) <= kMargin * error;
}

// pt/tasks/hit_sphere.h: the point lies on the sphere to 1e-6 radii, n is right to 1e-6. Rays that
// nearly touch the sphere are not used.
inline Meeting meet(const pt::Sphere& sphere, const pt::Ray& ray) {
  const double speed = length(ray.direction);
  const pt::Vec3 to_center = sphere.center - ray.origin, d = ray.direction / speed;
  const double middle = dot(to_center, d);
  const double beside = length(to_center - middle * d) / sphere.radius;
  Meeting meeting;
  meeting.n_error = 1e-6;
  if (beside > 1.01) return meeting;
  const double half = std::sqrt(std::max(0.0, 1 - beside * beside));
  meeting.t_error = 1e-6 * sphere.radius / (speed * std::max(half, 0.01));
  meeting.is_clear = beside < 0.99;
  for (const double side : {-1.0, 1.0}) {
    const double t = (middle + side * half * sphere.radius) / speed;
    if (is_near_an_end(t, meeting.t_error, ray)) meeting.is_clear = false;
  }
  return meeting;
}

// pt/tasks/hit_triangle.h: t is right to 1e-9 of the largest length in the case, and less precise
// in slivers and at small angles.
inline Meeting meet(const pt::Triangle& triangle, const pt::Ray& ray) {
  const pt::Vec3 a = triangle.p1 - triangle.p0, b = triangle.p2 - triangle.p0;
  const double speed = length(ray.direction);
  const double edge = std::max({length(a), length(b), length(b - a)});
  const pt::Vec3 normal = geometric_normal(triangle);
  const double height = length(normal) / edge;
  const double slope = dot(normal, ray.direction) / (length(normal) * speed);
  const double t = dot(normal, triangle.p0 - ray.origin) / dot(normal, ray.direction);
  Meeting meeting;
  if (!(std::abs(slope) > 1e-6)) {
    meeting.is_clear = false;
    return meeting;
  }
  const double size =
      std::max({max_abs(ray.origin), max_abs(triangle.p0) + edge, std::abs(t) * speed});
  const double error = 1e-9 * size * (edge / height) / std::abs(slope);
  meeting.t_error = error / speed;
  meeting.n_error = 1e-6 + 2 * error / height;
  const pt::Vec3 p = ray.at(t) - triangle.p0, n = normal / length_squared(normal);
  const double v = dot(cross(p, b), n), w = dot(cross(a, p), n);
  const double least = std::min({1 - v - w, v, w}), near_edge = kMargin * error / height;
  if (least < -near_edge) return meeting;
  meeting.is_clear = least > near_edge && !is_near_an_end(t, meeting.t_error, ray);
  return meeting;
}

// The ray's meeting with one primitive. The hit is the answer of the judge's own tasks.
inline Meeting meeting_of(const pt::Primitives& primitives, int i, const pt::Ray& ray) {
  Meeting meeting = primitives.is_triangle(i) ? meet(primitives.triangle(i), ray)
                                              : meet(primitives.sphere(i), ray);
  meeting.hit = hit_primitive(primitives, i, ray);
  return meeting;
}

struct Truth {
  std::vector<Meeting> meetings;  // one per primitive
  bool is_clear = true;           // all meetings are clear
  int nearest = -1;

  bool any() const { return nearest >= 0; }
  double t() const { return meetings[nearest].hit->t; }
};

// Tests every primitive.
inline Truth truth_of(const pt::Primitives& primitives, const pt::Ray& ray) {
  Truth truth;
  for (int i = 0; i < primitives.size(); ++i) {
    const Meeting meeting = meeting_of(primitives, i, ray);
    truth.is_clear = truth.is_clear && meeting.is_clear;
    truth.meetings.push_back(meeting);
    if (meeting.hit && !(truth.any() && truth.t() <= meeting.hit->t)) truth.nearest = i;
  }
  return truth;
}

inline Truth truth_of(const Case& c) { return truth_of(c.primitives, c.ray); }

inline std::string shown(const Truth& truth) {
  return truth.any() ? "t " + show(truth.t()) + " of primitive " + std::to_string(truth.nearest)
                     : "no hit";
}

inline std::string shown(const std::optional<pt::Hit>& hit) {
  return hit ? "t " + show(hit->t) + " of primitive " + std::to_string(hit->primitive) : "no hit";
}

}  // namespace grader::check::hit_bvh_inputs
