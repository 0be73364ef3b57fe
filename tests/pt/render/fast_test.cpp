#include "pt/tasks/camera_ray.h"
#include "pt/tasks/direct_lights.h"
#include "tests/proof/scenes.h"

#include <gtest/gtest.h>

// The program links the version of a task in fast/ if there is one. The plain version from
// reference/ gets another name here, so that the two can be compared.
#define direct_lights plain_direct_lights
#include "reference/3_direct/direct_lights.cpp"  // NOLINT(bugprone-suspicious-include)
#undef direct_lights
#define camera_ray plain_camera_ray
#include "reference/1_rays/camera_ray.cpp"  // NOLINT(bugprone-suspicious-include)
#undef camera_ray

namespace pt::proof {
namespace {

// Lights of every kind: some behind a surface, some that face away, and one that every shadow ray
// reaches.
Scene scene_with_lights(Engine engine) {
  SceneBuilder builder;
  builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({0.7, 0.5, 0.3}));
  const int gray_paint = builder.material(gray(0.6));
  builder.sphere({-0.3, -0.5, -0.2}, 0.4, gray_paint);
  builder.quad({0.2, 0.2, -0.6}, {0.5, 0, 0.1}, {0, 0.1, 0.5}, gray_paint);
  builder.light(RectangleLight{{0, 0.9, 0}, {0.6, 0, 0}, {0, 0, 0.6}, {0, -1, 0}, {2, 3, 4}});
  builder.light(RectangleLight{{0.2, -0.9, 0}, {0.5, 0, 0}, {0, 0, 0.5}, {0, -1, 0}, {7, 1, 1}});
  builder.light(SphereLight{{0.55, 0.5, -0.5}, 0.2, {6, 4, 2}});
  builder.light(PointLight{{-0.6, 0.7, 0.3}, {1, 2, 3}});
  builder.light(DirectionalLight{normalize({0.2, -1, 0.1}), {3, 3, 1}});
  builder.light(AmbientLight{{0.5, 0.6, 0.9}});
  const Vec3 a{-0.9, -0.2, -0.8}, b{-0.4, -0.1, -0.9}, c{-0.7, 0.4, -0.8};
  builder.light(mesh_light(std::vector<Triangle>{flat_triangle(a, b, c)}, {9, 8, 7}));
  return builder.finish(engine);
}

std::vector<SurfacePoint> points_of(const Scene& scene) {
  Camera camera;
  camera.position = {0.1, 0.05, 0.95};
  camera.hfov_deg = camera.vfov_deg = 80;
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 64; ++i) {
    const int row = i / 8;
    const Ray ray = camera_ray(camera, (i % 8 + 0.5) / 8, (row + 0.5) / 8);
    if (const std::optional<Hit> hit = scene.closest(ray)) {
      points.push_back(surface_point(scene, ray, *hit));
    }
  }
  return points;
}

TEST(FastDirectLights, has_the_bits_of_the_plain_loop) {
  for (const Engine engine : {Engine::linear, Engine::task, Engine::wide}) {
    const Scene scene = scene_with_lights(engine);
    int lit = 0;
    for (const SurfacePoint& point : points_of(scene)) {
      for (const int samples : {1, 2, 7, 8, 9, 16, 17, 50}) {
        Sampler plain_sampler(5), fast_sampler(5);
        const Rgb plain = plain_direct_lights(scene, point, samples, plain_sampler);
        const Rgb fast = direct_lights(scene, point, samples, fast_sampler);
        for (int c = 0; c < 3; ++c) ASSERT_EQ(plain[c], fast[c]) << samples << " samples";
        ASSERT_EQ(plain_sampler.next_1d(), fast_sampler.next_1d()) << samples << " samples";
        lit += !is_black(plain);
      }
    }
    EXPECT_GT(lit, 400);
  }
}

TEST(FastDirectLights, traces_the_rays_of_the_plain_loop) {
  const Scene scene = scene_with_lights(Engine::wide);
  for (const SurfacePoint& point : points_of(scene)) {
    Sampler plain_sampler(6), fast_sampler(6);
    const long long before = rays_traced().occluded;
    plain_direct_lights(scene, point, 20, plain_sampler);
    const long long between = rays_traced().occluded;
    direct_lights(scene, point, 20, fast_sampler);
    EXPECT_EQ(between - before, rays_traced().occluded - between);
  }
}

// Two cameras alternate; each has the other's fields of view.
TEST(FastCameraRay, has_the_bits_of_the_plain_one) {
  Camera one, other;
  one.position = {0.3, -2, 5};
  one.camera_to_world = frame_from_normal(normalize({0.2, 0.5, 0.8}));
  other.hfov_deg = one.vfov_deg = 31;
  other.vfov_deg = one.hfov_deg = 77;
  Sampler sampler(8);
  for (int i = 0; i < 1000; ++i) {
    const Camera& camera = i % 3 == 0 ? one : other;
    const Vec2 at = sampler.next_2d();
    const Ray plain = plain_camera_ray(camera, at.x, at.y), fast = camera_ray(camera, at.x, at.y);
    ASSERT_EQ(plain.direction, fast.direction);
    ASSERT_EQ(plain.origin, fast.origin);
    ASSERT_EQ(plain.t_max, fast.t_max);
  }
}

TEST(FastDirectLights, is_black_without_lights) {
  Scene scene = scene_with_lights(Engine::wide);
  const SurfacePoint point = points_of(scene).front();
  scene.lights.clear();
  Sampler sampler(7);
  EXPECT_TRUE(is_black(direct_lights(scene, point, 8, sampler)));
}

}  // namespace
}  // namespace pt::proof
