// The wide engine on meshes with the size and shape of real scenes, compared with a test of every
// primitive: generated meshes and files, also the course's own if they are present, with hard rays
// and a path tracer's rays. FIRSTLIGHT_LONG=1 runs a million rays per mesh.
#include "pt/accel/exact_hit.h"
#include "pt/accel/wide_bvh.h"
#include "pt/geometry/spawn_ray.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/scene.h"
#include "tests/pt/accel/generated_meshes.h"
#include "tests/pt/accel/hard_rays.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace pt {
namespace {

// The oracle tests every primitive. Because a million rays would take a day, it first tests whether
// the ray's line meets the primitive's box, enlarged by far more than any rounding.
bool may_meet(const Box& box, const Ray& ray, Vec3 inverse, double margin) {
  double begin = -kInfinity, end = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min[axis] - margin - ray.origin[axis];
    const double high = box.max[axis] + margin - ray.origin[axis];
    if (ray.direction[axis] == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    begin = std::max(begin, std::min(low * inverse[axis], high * inverse[axis]));
    end = std::min(end, std::max(low * inverse[axis], high * inverse[axis]));
  }
  return begin <= end + 1e-9 * std::abs(end);
}

struct Truth {
  const Primitives& primitives;
  std::vector<Box> boxes;
  double size;

  explicit Truth(const Primitives& these)
      : primitives(these), size(max_abs(bounds(these).extent())) {
    for (int i = 0; i < these.size(); ++i) boxes.push_back(bounds(these, i));
  }
  Brute operator()(const Ray& ray) const {
    const double margin = 1e-6 * (size + max_abs(ray.origin));
    const Vec3 inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z};
    Brute best;
    for (int i = 0; i < primitives.size(); ++i) {
      if (may_meet(boxes[i], ray, inverse, margin)) best = ask(primitives, i, ray, best);
    }
    return best;
  }
};

// Scales the mesh to about unit size around the origin, which hard_ray expects.
Primitives centred(Primitives primitives) {
  const Box box = bounds(primitives);
  const double scale = 2 / max_abs(box.extent());
  place(primitives.triangles, scale, -scale * box.center());
  for (Sphere& s : primitives.spheres) {
    s = {scale * (s.center - box.center()), scale * s.radius};
  }
  return primitives;
}

// Paths from random points: each ray leaves the surface that the last ray hit. Some shadow rays go
// to another point that was hit.
struct Walk {
  const Scene& scene;
  const WideBvh& bvh;
  Sampler sampler;
  Ray ray{};
  Vec3 lamp{};
  bool on_surface = false;
  SurfacePoint point{};  // the last hit point

  Ray next() {
    if (!on_surface) {
      ray = {1.2 * uniform_in_cube(sampler), uniform_direction(sampler)};
      on_surface = true;
    }
    const std::optional<Hit> hit = bvh.closest(scene.primitives, ray);
    if (!hit) {
      on_surface = false;
      return ray;
    }
    point = surface_point(scene, ray, *hit);
    ray = spawn_ray(point, point.frame.to_world(uniform_hemisphere(sampler.next_2d())));
    if (sampler.next_1d() < 0.5) return ray;
    const Vec3 to_lamp = lamp - point.p;
    lamp = point.p;
    const double distance = length(to_lamp);
    return distance > 0 ? shadow_ray(point, to_lamp / distance, distance) : ray;
  }

  // Shadow rays from the last hit point to eight points of a lamp near another point of the path.
  std::vector<Ray> shadow_rays() {
    const double size = std::pow(10, uniform(sampler, -3, 0));
    const Vec3 u = size * uniform_direction(sampler), v = size * uniform_direction(sampler);
    std::vector<Ray> rays;
    for (int i = 0; i < 8; ++i) {
      const Vec3 to = lamp + sampler.next_1d() * u + sampler.next_1d() * v - point.p;
      if (length(to) > 0) rays.push_back(shadow_ray(point, to / length(to), length(to)));
    }
    return rays;
  }
};

int rays_of_each() {
  const char* asked = std::getenv("FIRSTLIGHT_LONG");
  return asked != nullptr && *asked == '1' ? 1000000 : 4000;
}

// Bit k is set if ray k hits something.
std::uint32_t blocked(const Truth& truth, const std::vector<Ray>& rays) {
  std::uint32_t mask = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    mask |= std::uint32_t{truth(rays[k]).primitive >= 0} << k;
  }
  return mask;
}

// This many single rays, half of them hard, and half as many in groups. Returns how many of the
// single rays hit something.
int check(const Scene& scene, const WideBvh& bvh, const Truth& truth, int count,
          std::uint64_t seed) {
  Sampler sampler(seed);
  Walk walk{scene, bvh, Sampler(seed + 1000)};
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Ray ray = i % 2 == 0 ? hard_ray(scene.primitives, sampler) : walk.next();
    const Brute expected = truth(ray);
    hits += expected.primitive >= 0;
    auto answer = agrees(bvh, scene.primitives, ray, expected);
    std::vector<Ray> group;
    if (i % 32 == 0) group = hard_group(scene.primitives, sampler);
    if (i % 32 == 16 && walk.on_surface) group = walk.shadow_rays();
    if (answer) answer = group_agrees(bvh, scene.primitives, group, blocked(truth, group));
    if (!answer) {
      ADD_FAILURE() << answer.message();
      return hits;
    }
  }
  return hits;
}

void expect_exact(const Primitives& primitives) {
  Scene scene;
  scene.primitives = centred(primitives);
  scene.material_of.assign(static_cast<std::size_t>(scene.primitives.size()), 0);
  scene.materials.resize(1);
  const WideBvh bvh = WideBvh::build(scene.primitives);
  const Truth truth(scene.primitives);
  std::array<int, 2> hits{};
  {
    const int half = rays_of_each() / 2;
    std::jthread other([&] { hits[0] = check(scene, bvh, truth, half, 31); });
    hits[1] = check(scene, bvh, truth, half, 32);
  }
  std::cout << primitives.size() << " primitives: " << hits[0] + hits[1] << " of " << rays_of_each()
            << " rays hit\n";
  EXPECT_GT(hits[0] + hits[1], rays_of_each() / 20);
}

TEST(WideMeshes, generated_ones_are_traced_exactly) {
  expect_exact({blob(50, 0.2), {}});
  expect_exact({soup(5000, 0.1, 21), {}});
  expect_exact({grid(40), {{{0.3, 0.2, 0.4}, 0.3}}});
}

std::filesystem::path course_folder() {
  const char* named = std::getenv("FIRSTLIGHT_COURSE_SCENES");
  if (named != nullptr && *named != '\0') return named;
  return std::filesystem::path(FIRSTLIGHT_ROOT) / ".." / "shared" / "scenes";
}

class CourseMesh : public ::testing::TestWithParam<const char*> {};

TEST_P(CourseMesh, is_traced_exactly) {
  const std::filesystem::path file = course_folder() / GetParam();
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is not here; set FIRSTLIGHT_COURSE_SCENES to its folder";
  }
  LoadOptions options;
  options.lambertian = true;
  expect_exact(load_collada(file, options).scene.primitives);
}

INSTANTIATE_TEST_SUITE_P(EveryFile, CourseMesh,
                         ::testing::Values("sky/CBbunny.dae", "sky/CBcoil.dae", "sky/CBgems.dae",
                                           "sky/CBspheres.dae", "meshedit/cow.dae",
                                           "meshedit/maxplanck.dae"));

}  // namespace
}  // namespace pt
