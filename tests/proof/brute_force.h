#pragma once

#include "pt/geometry/primitives.h"
#include "pt/sampling/sampler.h"

#include <cmath>
#include <optional>
#include <vector>

// Rays against surfaces in long double, by plane and edges and by the plain quadratic formula. This
// is another method than the tasks', with 11 more bits, so its sure answers are right.

namespace pt::proof {

struct Exact {
  long double x = 0, y = 0, z = 0;

  Exact(long double x_, long double y_, long double z_) : x(x_), y(y_), z(z_) {}
  explicit Exact(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
};
inline Exact operator-(Exact a, Exact b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Exact operator+(Exact a, Exact b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Exact operator*(long double s, Exact a) { return {s * a.x, s * a.y, s * a.z}; }
inline long double dot(Exact a, Exact b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Exact cross(Exact a, Exact b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(Exact a) { return std::sqrt(dot(a, a)); }

// The meeting of a ray and one surface: a miss, a hit at t, or so close to an edge, a silhouette or
// an end of the range, or at such a small angle, that either answer is right. Then t is where the
// hit would be.
struct Meeting {
  enum class Kind { miss, hit, either } kind = Kind::miss;
  long double t = 0;
  long double error = 0;  // of a t in double
};

// Relative to the size of the numbers, double arithmetic may err at this distance: 2^12 roundings.
inline constexpr long double kClose = 0x1p-41L;

inline Meeting in_range(Meeting m, const Ray& ray) {
  if (m.t < ray.t_min - m.error || m.t > ray.t_max + m.error) return {};
  if (m.t < ray.t_min + m.error || m.t > ray.t_max - m.error) m.kind = Meeting::Kind::either;
  return m;
}

// A triangle without a plane has no hit. `kClose` is relative to the distance of the farthest
// corner, because the subtracted numbers have this size.
inline Meeting meet(const Triangle& triangle, const Ray& ray) {
  const Exact o(ray.origin), d(ray.direction), p0(triangle.p0), p1(triangle.p1), p2(triangle.p2);
  const Exact normal = cross(p1 - p0, p2 - p0);
  const long double size = std::max({length(p1 - p0), length(p2 - p0), length(p2 - p1)});
  const long double reach = std::max({length(p0 - o), length(p1 - o), length(p2 - o)}) + size;
  // The triple product, which is the divisor of everything, relative to the lengths. Within a
  // rounding of zero there is no hit; up to some hundred roundings, the place is unknown.
  const long double product = std::abs(dot(normal, d)) / (size * size * length(d));
  if (!(product > 0x1p-53L)) return {};
  const Exact n = (1 / length(normal)) * normal;
  const long double cosine = dot(n, d) / length(d);
  if (product < 0x1p-45L) return {Meeting::Kind::either, 0, HUGE_VALL};
  const long double t = dot(n, p0 - o) / (cosine * length(d));
  const Exact at = o + t * d;
  // The distances of the point in the plane from the edges, negative outside.
  const auto inside = [&](Exact a, Exact b) {
    return dot(n, cross(b - a, at - a)) / length(b - a);
  };
  const long double edge = std::min({inside(p0, p1), inside(p1, p2), inside(p2, p0)});
  // An error across the ray becomes larger along the plane, by the factor 1 / cosine.
  const long double slack = kClose * reach / std::abs(cosine) * (size * size / length(normal));
  if (edge < -slack) return {};
  return in_range({edge > slack ? Meeting::Kind::hit : Meeting::Kind::either, t, slack / length(d)},
                  ray);
}

// Both roots, the nearer first.
inline std::vector<Meeting> meet(const Sphere& sphere, const Ray& ray) {
  const Exact d(ray.direction), to_center = Exact(sphere.center) - Exact(ray.origin);
  const long double speed = length(d), radius = sphere.radius;
  const long double along = dot(to_center, d) / speed;
  const Exact aside = to_center - (along / speed) * d;
  const long double reach = length(to_center) + radius;
  const long double gap = radius - length(aside);
  if (gap < -kClose * reach) return {};
  const bool graze = gap < kClose * reach;
  const long double half = std::sqrt(std::max(0.0L, radius * radius - dot(aside, aside)));
  // Near the silhouette, an error of the gap moves the ends of the chord by its square root.
  const long double error =
      graze ? 2 * std::sqrt(2 * radius * kClose * reach) : kClose * reach * (1 + radius / half);
  std::vector<Meeting> meetings;
  for (const long double t : {along - half, along + half}) {
    const Meeting m = in_range(
        {graze ? Meeting::Kind::either : Meeting::Kind::hit, t / speed, error / speed}, ray);
    if (m.kind != Meeting::Kind::miss) meetings.push_back(m);
  }
  return meetings;
}

// All meetings of a ray, each with its surface.
struct Meetings {
  std::vector<Meeting> list;
  std::vector<int> primitives;
  bool sure = false;                // there is at least one hit
  long double nearest = HUGE_VALL;  // the smallest t + error of the hits

  void add(int primitive, const Meeting& m) {
    if (m.kind == Meeting::Kind::miss) return;
    list.push_back(m);
    primitives.push_back(primitive);
    if (m.kind != Meeting::Kind::hit) return;
    sure = true;
    nearest = std::min(nearest, m.t + m.error);
  }

  // Returns whether only one answer is right.
  bool decided() const { return sure || list.empty(); }

  // Returns whether the hit is one of the meetings and no sure meeting is nearer.
  bool allow_closest(const std::optional<Hit>& hit) const {
    if (!hit) return !sure;
    bool found = false;
    for (std::size_t i = 0; i < list.size(); ++i) {
      found = found ||
              (hit->primitive == primitives[i] && std::abs(hit->t - list[i].t) <= list[i].error);
    }
    const long double slack = kClose * std::abs(static_cast<long double>(hit->t));
    return found && hit->t <= nearest + slack && is_finite(hit->n);
  }

  bool allow_occluded(bool occluded) const { return occluded ? !list.empty() : !sure; }
};

inline Meetings meet_all(const Primitives& primitives, const Ray& ray) {
  Meetings all;
  for (int i = 0; i < primitives.size(); ++i) {
    if (primitives.is_triangle(i)) {
      all.add(i, meet(primitives.triangle(i), ray));
    } else {
      for (const Meeting& m : meet(primitives.sphere(i), ray)) all.add(i, m);
    }
  }
  return all;
}

}  // namespace pt::proof
