#include "pt/accel/wide_bvh.h"
#include "pt/math/frame.h"
#include "tests/pt/accel/generated_meshes.h"
#include "tests/pt/accel/hard_rays.h"

#include <array>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace pt {
namespace {

std::vector<const Kernel*> kernels() {
  std::vector<const Kernel*> result;
  for (const char* name : {"plain", "v2", "v3", "v4"}) {
    if (const Kernel* kernel = find_kernel(name)) result.push_back(kernel);
  }
  return result;
}

struct Mesh {
  std::string name;
  Primitives primitives;
};

std::vector<Triangle> slivers() {
  std::vector<Triangle> triangles;
  Sampler sampler(11);
  for (int i = 0; i < 150; ++i) {
    const Vec3 p = uniform_in_cube(sampler), along = uniform_in_cube(sampler);
    const double width = std::pow(10, uniform(sampler, -9, -3));
    triangles.push_back(
        flat_triangle(p, p + along, p + 0.5 * along + width * uniform_in_cube(sampler)));
  }
  return triangles;
}

std::vector<Triangle> same_centroids() {
  std::vector<Triangle> triangles;
  Sampler sampler(12);
  for (int i = 0; i < 60; ++i) {
    const Vec3 a = uniform_in_cube(sampler), b = uniform_in_cube(sampler);
    triangles.push_back(flat_triangle(a, b, -(a + b)));
    triangles.push_back(flat_triangle(-a, -b, a + b));
  }
  return triangles;
}

// Triangles at 2^-i: planes in the middle of the longest axis would make a tree as deep as the
// number of triangles.
std::vector<Triangle> clustered() {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 200; ++i) {
    const double s = std::ldexp(1.0, -i);
    triangles.push_back(flat_triangle({s, 0, 0}, {s, 0.5 * s, 0}, {s, 0, 0.5 * s}));
  }
  return triangles;
}

std::vector<Triangle> degenerate() {
  std::vector<Triangle> triangles = soup(60, 0.5, 13);
  Sampler sampler(14);
  for (int i = 0; i < 60; ++i) {
    const Vec3 p = uniform_in_cube(sampler), q = uniform_in_cube(sampler), n{0, 0, 1};
    triangles.push_back({p, p, p, n, n, n});
    triangles.push_back({p, q, q, n, n, n});
    triangles.push_back({p, 0.5 * (p + q), q, n, n, n});
  }
  const double nan = std::nan("");
  triangles.push_back({{nan, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  triangles.push_back({{0, 0, 0}, {kInfinity, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  return triangles;
}

std::vector<Triangle> duplicates() {
  std::vector<Triangle> triangles = blob(4);
  const std::vector<Triangle> once = triangles;
  for (int i = 0; i < 3; ++i) triangles.insert(triangles.end(), once.begin(), once.end());
  return triangles;
}

std::vector<Triangle> many_sizes() {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 8; ++i) {
    const std::vector<Triangle> more = soup(25, std::pow(10, -i), 15 + i);
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  return triangles;
}

std::vector<Sphere> some_spheres(int count, double radius) {
  Sampler sampler(16);
  std::vector<Sphere> spheres;
  spheres.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) spheres.push_back({uniform_in_cube(sampler), radius});
  return spheres;
}

std::vector<Mesh> meshes() {
  return {{"blob", {blob(8), {}}},
          {"flat grid", {grid(9), {}}},
          {"soup", {soup(150, 0.3, 1), {}}},
          {"slivers", {slivers(), {}}},
          {"same centroids", {same_centroids(), {}}},
          {"clustered", {clustered(), {}}},
          {"degenerate", {degenerate(), {}}},
          {"duplicates", {duplicates(), {}}},
          {"many sizes", {many_sizes(), {}}},
          {"one triangle", {soup(1, 1, 2), {}}},
          {"spheres", {{}, some_spheres(80, 0.2)}},
          {"spheres and triangles", {soup(100, 0.3, 3), some_spheres(30, 0.3)}},
          {"a ground that is a sphere", {blob(6), {{{0, 0, -1e5 - 1}, 1e5}}}}};
}

void place(Primitives& primitives, double scale, Vec3 shift) {
  place(primitives.triangles, scale, shift);
  for (Sphere& s : primitives.spheres) s = {scale * s.center + shift, scale * s.radius};
}

void place(Ray& ray, double scale, Vec3 shift) {
  ray.origin = scale * ray.origin + shift;
  ray.direction *= scale;
}

std::vector<WideBvh> with_each(const std::vector<const Kernel*>& kernels,
                               const Primitives& primitives) {
  std::vector<WideBvh> bvhs;
  bvhs.reserve(kernels.size());
  for (const Kernel* kernel : kernels) bvhs.push_back(WideBvh::build(primitives, *kernel));
  return bvhs;
}

// A triangle that another ray hits. If this ray misses it, the ray may claim to leave it.
std::int64_t if_missed(const Primitives& primitives, const Brute& hit, const Ray& ray) {
  if (hit.primitive < 0 || !primitives.is_triangle(hit.primitive)) return -1;
  return exact_hit(primitives.triangle(hit.primitive), ray).hit ? -1 : hit.primitive;
}

struct Placement {
  double scale;
  Vec3 shift;
};
class Wide : public ::testing::TestWithParam<Placement> {};

TEST_P(Wide, answers_like_asking_every_primitive_with_any_kernel) {
  const auto [scale, shift] = GetParam();
  const std::vector<const Kernel*> all = kernels();
  std::uint64_t seed = 100;
  for (const Mesh& mesh : meshes()) {
    Sampler sampler(++seed);
    std::vector<Ray> rays;
    for (int i = 0; i < 10000; ++i) {
      rays.push_back(hard_ray(mesh.primitives, sampler));
      place(rays.back(), scale, shift);
    }
    Primitives primitives = mesh.primitives;
    place(primitives, scale, shift);
    const std::vector<WideBvh> bvhs = with_each(all, primitives);
    int hits = 0;
    for (const Ray& ray : rays) {
      const Brute expected = brute_force(primitives, ray);
      hits += expected.primitive >= 0;
      for (std::size_t k = 0; k < all.size(); ++k) {
        ASSERT_TRUE(agrees(bvhs[k], primitives, ray, expected))
            << mesh.name << ", " << all[k]->name;
      }
    }
    EXPECT_GT(hits, 100) << mesh.name;
  }
}

TEST_P(Wide, answers_groups_from_one_point_like_asking_every_primitive) {
  const auto [scale, shift] = GetParam();
  const std::vector<const Kernel*> all = kernels();
  std::uint64_t seed = 200;
  for (const Mesh& mesh : meshes()) {
    Sampler sampler(++seed);
    Primitives primitives = mesh.primitives;
    place(primitives, scale, shift);
    const std::vector<WideBvh> bvhs = with_each(all, primitives);
    int hits = 0;
    for (int i = 0; i < 1500; ++i) {
      std::vector<Ray> rays = hard_group(mesh.primitives, sampler);
      std::uint32_t expected = 0;
      for (std::size_t k = 0; k < rays.size(); ++k) {
        place(rays[k], scale, shift);
        const Brute hit = brute_force(primitives, rays[k]);
        expected |= std::uint32_t{hit.primitive >= 0} << k;
        if (i % 4 == 0 && k > 0)
          rays[k - 1].source_triangle = if_missed(primitives, hit, rays[k - 1]);
      }
      hits += std::popcount(expected);
      for (std::size_t k = 0; k < all.size(); ++k) {
        ASSERT_TRUE(group_agrees(bvhs[k], primitives, rays, expected))
            << mesh.name << ", " << all[k]->name;
      }
    }
    EXPECT_GT(hits, 100) << mesh.name;
  }
}

// Rays past the side of a sphere, inside or outside by a little or nothing, that start on it or
// elsewhere; the range begins or ends close to the hit.
Ray grazing_ray(const Sphere& sphere, Sampler& sampler) {
  const auto little = [&] {
    const double size = sampler.next_1d() < 0.2 ? 0 : std::pow(10, uniform(sampler, -17, -1));
    return 1 + (sampler.next_1d() < 0.5 ? -size : size);
  };
  const Frame frame = frame_from_normal(uniform_direction(sampler));
  const Vec3 side = sphere.center + little() * sphere.radius * frame.z;
  const double length = std::pow(10, uniform(sampler, -4, 1));
  Ray ray{side - (sampler.next_1d() < 0.3 ? 0 : length) * frame.x, length * frame.x};
  if (sampler.next_1d() < 0.3) ray.direction += 0.1 * sampler.next_1d() * length * frame.z;
  const ExactHit hit = exact_hit(sphere, ray);
  const int range = static_cast<int>(4 * sampler.next_1d());
  if (hit.hit && range == 0) ray.t_min = std::max(0.0, hit.t * little());
  if (hit.hit && range == 1) ray.t_max = std::max(0.0, hit.t * little());
  return ray;
}

TEST_P(Wide, answers_rays_that_graze_spheres) {
  const auto [scale, shift] = GetParam();
  const std::vector<const Kernel*> all = kernels();
  for (const Mesh& mesh : {Mesh{"one", {{}, {{{0.1, 0.2, 0.3}, 0.4}}}},
                           Mesh{"in a block of triangles", {blob(2), some_spheres(6, 0.5)}},
                           Mesh{"many", {{}, some_spheres(40, 0.3)}}}) {
    Sampler sampler(300);
    Primitives primitives = mesh.primitives;
    place(primitives, scale, shift);
    const std::vector<WideBvh> bvhs = with_each(all, primitives);
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
      const auto& spheres = mesh.primitives.spheres;
      std::vector<Ray> rays{
          grazing_ray(spheres[static_cast<std::size_t>(i) % spheres.size()], sampler)};
      rays.resize(4, rays.front());
      for (Ray& ray : rays) {
        ray.direction += 1e-8 * sampler.next_1d() * uniform_direction(sampler);
        place(ray, scale, shift);
      }
      std::uint32_t blocked = 0;
      for (std::size_t k = 0; k < rays.size(); ++k) {
        const Brute expected = brute_force(primitives, rays[k]);
        blocked |= std::uint32_t{expected.primitive >= 0} << k;
        if (k > 0) continue;
        for (std::size_t j = 0; j < all.size(); ++j) {
          ASSERT_TRUE(agrees(bvhs[j], primitives, rays[k], expected)) << mesh.name << all[j]->name;
        }
      }
      hits += std::popcount(blocked);
      for (std::size_t j = 0; j < all.size(); ++j) {
        ASSERT_TRUE(group_agrees(bvhs[j], primitives, rays, blocked)) << mesh.name << all[j]->name;
      }
    }
    EXPECT_GT(hits, 2000) << mesh.name;
    EXPECT_LT(hits, 15900) << mesh.name;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryPlace, Wide,
                         ::testing::Values(Placement{1, {}}, Placement{1e-6, {}},
                                           Placement{1e6, {}}, Placement{1, {1e4, -3e4, 2e4}},
                                           Placement{1e-6, {1, 1, -1}}, Placement{0x1p-50, {}},
                                           Placement{3e60, {}}));

}  // namespace
}  // namespace pt
