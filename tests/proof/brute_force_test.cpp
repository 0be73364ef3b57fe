#include "tests/proof/brute_force.h"

#include "pt/scene/tracer.h"
#include "tests/proof/meshes.h"

#include <gtest/gtest.h>

// Both engines, compared with a test of every surface in long double.

namespace pt::proof {
namespace {

int any_of(const Primitives& primitives, Sampler& sampler) {
  return static_cast<int>(sampler.next_1d() * primitives.size());
}

// Rays of all kinds: between random points; at a point of a surface, so that most of them hit;
// between two surfaces; along an axis from a corner's coordinates, with zeros of both signs, so
// that they start in the planes of boxes; and with any length of the direction and any range.
Ray any_ray(const Primitives& primitives, int kind, Sampler& sampler) {
  const Vec3 target = point_of(primitives, any_of(primitives, sampler), sampler);
  switch (kind % 5) {
    case 0:
      return {in_cube(sampler, 2), in_cube(sampler), 0, kInfinity};
    case 1: {
      const Vec3 origin = in_cube(sampler, 3);
      return {origin, target - origin, 0, kInfinity};
    }
    case 2: {
      const Vec3 origin = point_of(primitives, any_of(primitives, sampler), sampler);
      return {origin, target - origin, 1e-3, 2};
    }
    case 3: {
      const int axis = static_cast<int>(sampler.next_1d() * 3);
      const double zero = sampler.next_1d() < 0.5 ? 0.0 : -0.0;
      Vec3 direction{zero, zero, zero}, origin = on_grid(sampler);
      direction[axis] = sampler.next_1d() < 0.5 ? -1 : 1;
      if (sampler.next_1d() < 0.5) direction[(axis + 1) % 3] = 0.5;
      if (sampler.next_1d() < 0.7) origin[(axis + 1) % 3] = target[(axis + 1) % 3];
      origin[axis] = -3 * direction[axis];
      return {origin, direction, 0, kInfinity};
    }
    default: {
      const Vec3 origin = in_cube(sampler, 3);
      const double stretch = std::pow(10, 6 * sampler.next_1d() - 3);
      const double from = sampler.next_1d() / stretch;
      return {origin, stretch * (target - origin), from, from + 1 / stretch};
    }
  }
}

Tracer tracer_of(int kind, const Primitives& primitives) {
  return kind == 0 ? Tracer(Engine::linear, primitives) : Tracer(Engine::task, primitives, kind);
}

// Engine 0 is linear; the others have leaves of 1 to 8 surfaces.
void expect_brute_force(const Mesh& mesh, int rays) {
  const Primitives& primitives = mesh.primitives;
  std::vector<Tracer> tracers;
  for (int kind = 0; kind <= 8; ++kind) tracers.push_back(tracer_of(kind, primitives));
  Sampler sampler(64);
  int decided = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = any_ray(primitives, i, sampler);
    const Meetings truth = meet_all(primitives, ray);
    decided += truth.decided() ? 1 : 0;
    for (int kind = 0; kind <= 8; ++kind) {
      const std::optional<Hit> hit = tracers[kind].closest(primitives, ray);
      const bool occluded = tracers[kind].occluded(primitives, ray);
      const std::string what =
          mesh.name + ", leaves of " + std::to_string(kind) + ", ray " + std::to_string(i);
      ASSERT_TRUE(truth.allow_closest(hit)) << what << ": t = " << (hit ? hit->t : -1)
                                            << ", primitive " << (hit ? hit->primitive : -1);
      ASSERT_TRUE(truth.allow_occluded(occluded)) << what;
      ASSERT_EQ(occluded, hit.has_value()) << what;
    }
  }
  // The oracle must decide most rays. (A flat grid of surfaces shares all its coordinates with the
  // rays along its axes, a fifth of all rays.)
  EXPECT_GT(decided, rays * 0.75) << mesh.name;
}

TEST(BruteForce, agrees_with_both_engines) {
  for (const Mesh& mesh : meshes()) expect_brute_force(mesh, 2000);
}

TEST(BruteForce, agrees_where_there_is_nothing) {
  const Primitives none;
  for (const Engine engine : {Engine::linear, Engine::task}) {
    const Tracer tracer(engine, none);
    EXPECT_FALSE(tracer.closest(none, {{}, {0, 0, 1}, 0, kInfinity}));
    EXPECT_FALSE(tracer.occluded(none, {{}, {0, 0, 1}, 0, kInfinity}));
  }
}

// A ray at a surface without area never hits it: there is neither t nor a normal.
TEST(BruteForce, never_meets_what_has_no_area) {
  const Primitives lines = without_area().primitives;
  Sampler sampler(65);
  for (int i = 0; i < 300000; ++i) {
    const int primitive = any_of(lines, sampler);
    const Vec3 target = point_of(lines, primitive, sampler);
    const Vec3 origin = i % 2 == 0 ? in_cube(sampler, 3) : on_grid(sampler);
    const Ray ray{origin, target - origin, 0, kInfinity};
    ASSERT_FALSE(hit_triangle(lines.triangle(primitive), ray)) << "triangle " << primitive;
  }
}

// A ray in the plane of a triangle misses it too, whatever the plane. Its ends are rounded by less
// than 16 roundings of the direction's length, unless this is too short.
TEST(BruteForce, never_meets_a_plane_it_runs_in) {
  Sampler sampler(66);
  for (int i = 0; i < 300000; ++i) {
    const Vec3 e1 = in_cube(sampler), e2 = in_cube(sampler);
    const double a = 4 * sampler.next_1d() - 2, b = 4 * sampler.next_1d() - 2;
    const Vec3 origin = a * e1 + b * e2;
    const Ray ray{origin, 0.3 * e1 + 0.3 * e2 - origin, 0, kInfinity};
    if (length(ray.direction) < 1.5) continue;
    ASSERT_FALSE(hit_triangle(any_triangle({}, e1, e2), ray)) << i;
  }
}

}  // namespace
}  // namespace pt::proof
