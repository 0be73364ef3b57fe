#pragma once

#include "pt/accel/exact_hit.h"
#include "pt/accel/wide_bvh.h"
#include "tests/pt/accel/generated_meshes.h"

#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// Rays that are hard to answer, and their answers, for the tests of the wide engine.

namespace pt {

// The oracle: every primitive in turn, decided by the test that the engine promises to match.
struct Brute {
  double t = 0;
  int primitive = -1;
};

// Returns the nearer of `best` and the hit of primitive i.
inline Brute ask(const Primitives& primitives, int i, const Ray& ray, const Brute& best) {
  const ExactHit hit = primitives.is_triangle(i) ? exact_hit(primitives.triangle(i), ray)
                                                 : exact_hit(primitives.sphere(i), ray);
  if (hit.hit && (best.primitive < 0 || hit.t < best.t)) return {hit.t, i};
  return best;
}

inline Brute brute_force(const Primitives& primitives, const Ray& ray) {
  Brute best;
  for (int i = 0; i < primitives.size(); ++i) best = ask(primitives, i, ray, best);
  return best;
}

// A point that tests find hard: a corner, a point on an edge, in a triangle, or near the mesh.
inline Vec3 target(const Primitives& primitives, Sampler& sampler) {
  const int kind = static_cast<int>(5 * sampler.next_1d());
  const Vec3 anywhere = 1.2 * uniform_in_cube(sampler);
  if (primitives.triangles.empty() || kind == 4) return anywhere;
  const auto count = static_cast<double>(primitives.triangles.size());
  const Triangle& t = primitives.triangles[static_cast<std::size_t>(count * sampler.next_1d())];
  const double a = sampler.next_1d(), b = sampler.next_1d() * (1 - a);
  if (kind == 0) return t.p1;
  if (kind == 1) return t.p0 + a * (t.p1 - t.p0);
  if (kind == 2) return t.p2 + 0.5 * (t.p1 - t.p2);
  return t.p0 + a * (t.p1 - t.p0) + b * (t.p2 - t.p0);
}

inline Vec3 hard_direction(Vec3 d, Sampler& sampler) {
  const int kind = static_cast<int>(8 * sampler.next_1d());
  if (kind == 0) d.x = 0;
  if (kind == 1) d.y = -0.0;
  if (kind == 2) d = {0, -0.0, d.z};
  if (kind == 3) d = {-d.x, 0, -0.0};
  if (kind == 4) d.z *= 1e-9;
  if (kind == 5) d.x *= 1e-70;
  return d == Vec3{} ? Vec3{0, 0, 1} : d;
}

// A ray for a mesh of about unit size at the origin: towards or away from a target, from near, from
// far, or from another target.
inline Ray hard_ray(const Primitives& primitives, Sampler& sampler) {
  const Vec3 to = target(primitives, sampler);
  Ray ray;
  const int from = static_cast<int>(6 * sampler.next_1d());
  ray.origin = 1.5 * uniform_in_cube(sampler);
  if (from == 0) ray.origin = target(primitives, sampler);
  if (from == 1) ray.origin = std::pow(10, uniform(sampler, 0, 9)) * uniform_in_cube(sampler);
  ray.direction = to - ray.origin;
  if (from == 2 || ray.direction == Vec3{}) ray.direction = uniform_direction(sampler);
  if (from == 3) {
    ray.direction = hard_direction(ray.direction, sampler);
    ray.origin = to - ray.direction;
  }
  ray.direction *= std::pow(10, uniform(sampler, -3, 3));
  const int range = static_cast<int>(6 * sampler.next_1d());
  const double t = 1 / max_abs(ray.direction);
  if (range == 0) ray.t_max = 2 * t * sampler.next_1d();
  if (range == 1) ray.t_min = 2 * t * sampler.next_1d();
  if (range == 2) ray.t_min = -t, ray.t_max = t;
  if (range == 3) ray.t_min = -kInfinity, ray.t_max = -t * sampler.next_1d();
  return ray;
}

// Three to eight rays from one point that differ only in their direction, like shadow rays: towards
// any targets, around one target, or along an edge. In three of eight groups the last ray differs
// in something else too.
inline std::vector<Ray> hard_group(const Primitives& primitives, Sampler& sampler) {
  const Ray first = hard_ray(primitives, sampler);
  const Vec3 to = first.origin + first.direction;
  const int kind = static_cast<int>(4 * sampler.next_1d());
  const double size = std::pow(10, uniform(sampler, -8, 0)) * length(first.direction);
  const Vec3 edge = size * uniform_direction(sampler);
  std::vector<Ray> rays(static_cast<std::size_t>(uniform(sampler, 3, 9)), first);
  for (Ray& ray : rays) {
    Vec3 there = target(primitives, sampler);
    if (kind == 1) there = to + size * uniform_in_cube(sampler);
    if (kind == 2) there = to + sampler.next_1d() * edge;
    if (kind != 3 && !(there == ray.origin)) ray.direction = there - ray.origin;
    if (kind == 0) ray.t_min = 0, ray.t_max = 1 - 0x1p-14;
  }
  Ray& last = rays.back();
  const int unlike = static_cast<int>(8 * sampler.next_1d());
  if (unlike == 0) last.t_max = sampler.next_1d();
  if (unlike == 1) last.t_min = 2 * sampler.next_1d();
  if (unlike == 2) last.origin = target(primitives, sampler);
  return rays;
}

inline std::string text(const Ray& ray) {
  char line[400];
  std::snprintf(line, sizeof line, "{{%a,%a,%a},{%a,%a,%a},%a,%a}", ray.origin.x, ray.origin.y,
                ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.t_min,
                ray.t_max);
  return line;
}

// Returns whether the engine's answers for the ray equal those of the oracle, bit for bit.
inline ::testing::AssertionResult agrees(const WideBvh& bvh, const Primitives& primitives,
                                         const Ray& ray, const Brute& expected) {
  const std::optional<Hit> hit = bvh.closest(primitives, ray);
  const int primitive = hit ? hit->primitive : -1;
  if (primitive != expected.primitive || (hit && hit->t != expected.t)) {
    return ::testing::AssertionFailure()
           << text(ray) << " hits " << primitive << " at " << (hit ? hit->t : 0) << ", expected "
           << expected.primitive << " at " << expected.t;
  }
  if (bvh.occluded(primitives, ray) != (expected.primitive >= 0)) {
    return ::testing::AssertionFailure() << text(ray) << ": wrong answer of occluded";
  }
  return ::testing::AssertionSuccess();
}

// Returns whether the engine blocks exactly the rays of the group whose bits `expected` has.
inline ::testing::AssertionResult group_agrees(const WideBvh& bvh, const Primitives& primitives,
                                               const std::vector<Ray>& rays,
                                               std::uint32_t expected) {
  const std::uint32_t blocked = bvh.occluded(primitives, rays);
  if (blocked == expected) return ::testing::AssertionSuccess();
  auto failure = ::testing::AssertionFailure();
  failure << "of the rays";
  for (const Ray& ray : rays) failure << ' ' << text(ray);
  return failure << " those of " << blocked << " are blocked, expected " << expected;
}

}  // namespace pt
