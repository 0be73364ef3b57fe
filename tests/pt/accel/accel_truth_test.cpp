// The wide engine, compared with independent truths: arithmetic of higher precision, closed
// surfaces, and the machine code itself.
#include "pt/accel/wide_bvh.h"
#include "pt/scene/scene.h"
#include "tests/pt/accel/generated_meshes.h"

#include <array>

#include <gtest/gtest.h>

namespace pt {
namespace {

using Long = long double;
struct LongVec {
  Long x, y, z;
};
LongVec widen(Vec3 a) { return {a.x, a.y, a.z}; }
LongVec operator-(LongVec a, LongVec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Long dot(LongVec a, LongVec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
LongVec cross(LongVec a, LongVec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Long length(LongVec a) { return std::sqrt(dot(a, a)); }

// The hit of a ray with a triangle's plane, by Cramer's rule, and its distance from the edges (in
// barycentric coordinates: negative outside).
struct LongHit {
  Long t = 0, inside = 0, cosine = 0;
};
LongHit long_hit(const Triangle& triangle, const Ray& ray) {
  const LongVec p0 = widen(triangle.p0), d = widen(ray.direction);
  const LongVec e1 = widen(triangle.p1) - p0, e2 = widen(triangle.p2) - p0;
  const LongVec s = widen(ray.origin) - p0, n = cross(e1, e2);
  const Long det = -dot(d, n);
  const Long b1 = dot(cross(s, d), e2) / det, b2 = dot(cross(s, d), e1) / -det;
  LongHit hit;
  hit.t = dot(s, n) / det;
  hit.inside = std::min({b1, b2, 1 - b1 - b2});
  hit.cosine = std::abs(det) / (length(d) * length(n));
  return hit;
}

// The nearest hit, unless it is a close call: near an edge, near the origin, at a grazing angle, or
// with another hit just as near.
struct LongNearest {
  bool clear = true;
  int primitive = -1;
  LongHit hit;
};
LongNearest long_nearest(const std::vector<Triangle>& triangles, const Ray& ray) {
  constexpr Long kClose = 1e-9L;
  LongNearest best;
  best.hit.t = kInfinity;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const LongHit hit = long_hit(triangles[i], ray);
    if (!(hit.inside >= -kClose) || !(hit.t >= -kClose)) continue;
    const bool close = hit.inside < kClose || hit.t < kClose || hit.cosine < 1e-3L;
    if (close || std::abs(hit.t - best.hit.t) < kClose) best.clear = false;
    if (hit.t < best.hit.t) {
      best.hit = hit;
      best.primitive = static_cast<int>(i);
    }
  }
  return best;
}

// exact_hit is right for a triangle whose corners move by at most 16 rounding errors of M, their
// largest distance from the origin. So the plane moves by at most 16 sqrt(3) u M / cosine.
TEST(Wide, agrees_with_long_double_where_the_case_is_clear) {
  Sampler sampler(5);
  for (const double scale : {1.0, 1e-6, 1e6}) {
    Primitives primitives{soup(200, 0.5, 4), {}};
    place(primitives.triangles, scale, {});
    const WideBvh bvh = WideBvh::build(primitives);
    int clear = 0;
    for (int i = 0; i < 5000; ++i) {
      const Ray ray{1.5 * scale * uniform_in_cube(sampler), scale * uniform_direction(sampler)};
      const LongNearest expected = long_nearest(primitives.triangles, ray);
      if (!expected.clear) continue;
      ++clear;
      const std::optional<Hit> hit = bvh.closest(primitives, ray);
      ASSERT_EQ(hit ? hit->primitive : -1, expected.primitive);
      if (!hit) continue;
      const double reach = 4 * scale;  // origins within 1.5, corners within 1.5
      const double bound = 16 * std::sqrt(3.0) * 0x1p-53 * reach /
                           (scale * static_cast<double>(expected.hit.cosine));
      EXPECT_NEAR(hit->t, static_cast<double>(expected.hit.t), bound);
    }
    EXPECT_GT(clear, 4500);
  }
}

TEST(Wide, leaks_nowhere_from_a_closed_surface) {
  Sampler sampler(6);
  for (const double scale : {1.0, 1e-6, 1e6}) {
    const Vec3 shift = scale * Vec3{3, -5, 7};
    Primitives primitives{blob(12), {}};
    place(primitives.triangles, scale, shift);
    for (const char* name : {"plain", "v2", "v3", "v4"}) {
      const Kernel* kernel = find_kernel(name);
      if (!kernel) continue;
      const WideBvh bvh = WideBvh::build(primitives, *kernel);
      for (const Triangle& t : primitives.triangles) {
        for (int i = 0; i < 30; ++i) {
          const Vec3 from = shift + 0.5 * scale * uniform_in_cube(sampler);
          const Vec3 edge = t.p0 + sampler.next_1d() * (t.p1 - t.p0);
          const Ray at_corner{from, t.p2 - from}, at_edge{from, edge - from};
          ASSERT_TRUE(bvh.closest(primitives, at_corner) && bvh.occluded(primitives, at_corner));
          ASSERT_TRUE(bvh.closest(primitives, at_edge) && bvh.occluded(primitives, at_edge));
        }
      }
    }
  }
}

TEST(Wide, answers_a_batch_like_one_ray_at_a_time) {
  Sampler sampler(7);
  Scene scene;
  scene.primitives = {soup(300, 0.3, 8), {{{0.5, 0, 0}, 0.2}}};
  for (const Engine engine : {Engine::linear, Engine::task, Engine::wide}) {
    scene.tracer = Tracer(engine, scene.primitives);
    for (int i = 0; i < 300; ++i) {
      const Vec3 from = uniform_in_cube(sampler);
      std::vector<Ray> rays(static_cast<std::size_t>(i % 33));
      for (Ray& ray : rays) ray = {from, uniform_direction(sampler), 0, sampler.next_1d()};
      const std::uint32_t blocked = scene.occluded(rays);
      for (std::size_t k = 0; k < 32; ++k) {
        EXPECT_EQ(blocked >> k & 1, k < rays.size() && scene.occluded(rays[k]) ? 1u : 0u);
      }
    }
  }
}

TEST(Wide, interpolates_the_corner_normals) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Primitives primitives{{{{0, 0, 0}, x, y, x, y, z}}, {{{5, 0, 0}, 1}}};
  const WideBvh bvh = WideBvh::build(primitives);
  const std::optional<Hit> hit = bvh.closest(primitives, {{0.25, 0.5, 1}, {0, 0, -2}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 0.5);
  EXPECT_NEAR(length(hit->n - normalize({0.25, 0.25, 0.5})), 0, 1e-15);
  const std::optional<Hit> from_inside = bvh.closest(primitives, {{5, 0, 0}, {0, 2, 0}});
  ASSERT_TRUE(from_inside);
  EXPECT_EQ(from_inside->t, 0.5);
  EXPECT_EQ(from_inside->n, y);
}

TEST(Wide, finds_nothing_where_nothing_is) {
  const Primitives none;
  const std::array<Ray, 2> rays{Ray{{}, {1, 0, 0}}, Ray{{}, {0, 0, 0}}};
  for (const WideBvh& bvh : {WideBvh(), WideBvh::build(none)}) {
    EXPECT_FALSE(bvh.closest(none, rays[0]));
    EXPECT_FALSE(bvh.occluded(none, rays[0]));
    EXPECT_EQ(bvh.occluded(none, rays), 0u);
  }
}

TEST(Wide, needs_at_most_100_bytes_a_triangle) {
  for (const char* name : {"plain", "v2", "v3", "v4"}) {
    const Kernel* kernel = find_kernel(name);
    if (!kernel) continue;
    for (const Primitives& primitives :
         {Primitives{blob(70), {}}, Primitives{soup(20000, 0.05, 9), {}}}) {
      const WideBvh bvh = WideBvh::build(primitives, *kernel);
      EXPECT_LE(bvh.bytes(), 100 * primitives.triangles.size()) << name;
    }
  }
}

}  // namespace
}  // namespace pt
