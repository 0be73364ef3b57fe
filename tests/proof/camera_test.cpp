#include "pt/sampling/sampler.h"
#include "pt/tasks/camera_ray.h"
#include "tests/proof/closed_forms.h"
#include "tests/proof/statistics.h"

// camera_ray, tested by its contract's statements on angles and the window, for any camera.

namespace pt::proof {
namespace {

std::vector<Camera> cameras() {
  std::vector<Camera> all(3);
  all[1].hfov_deg = 90;
  all[1].vfov_deg = 20;
  all[1].position = {3, -4, 5};
  all[1].camera_to_world = frame_from_normal(normalize({1, -2, 0.5}));
  all[1].near_clip = 0.25;
  all[1].far_clip = 40;
  all[2].hfov_deg = 1;
  all[2].vfov_deg = 170;
  all[2].position = {1e6, 0, 0};
  all[2].camera_to_world = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  return all;
}

double degrees(double radians) { return radians * 180 / kPi; }

TEST(CameraRay, fills_the_field_of_view) {
  for (const Camera& camera : cameras()) {
    const Vec3 ahead = camera_ray(camera, 0.5, 0.5).direction;
    EXPECT_NEAR(length(ahead + camera.camera_to_world.z), 0, 1e-15);
    const Vec3 left = camera_ray(camera, 0, 0.5).direction;
    const Vec3 right = camera_ray(camera, 1, 0.5).direction;
    const Vec3 bottom = camera_ray(camera, 0.5, 0).direction;
    const Vec3 top = camera_ray(camera, 0.5, 1).direction;
    for (const Vec3 side : {left, right}) {
      EXPECT_NEAR(degrees(angle(ahead, side)), camera.hfov_deg / 2, 1e-12);
    }
    for (const Vec3 end : {bottom, top}) {
      EXPECT_NEAR(degrees(angle(ahead, end)), camera.vfov_deg / 2, 1e-12);
    }
    EXPECT_GT(dot(right, camera.camera_to_world.x), 0);
    EXPECT_GT(dot(top, camera.camera_to_world.y), 0);
    EXPECT_LT(dot(left, camera.camera_to_world.x), 0);
    EXPECT_LT(dot(bottom, camera.camera_to_world.y), 0);
  }
}

// The ray meets the window at (2x - 1, 2y - 1), in units of half its width and height.
TEST(CameraRay, keeps_the_picture_flat) {
  Sampler sampler(91);
  for (const Camera& camera : cameras()) {
    const Vec3 corner = camera.camera_to_world.to_local(camera_ray(camera, 1, 1).direction);
    for (int i = 0; i < 1000; ++i) {
      const Vec2 xi = sampler.next_2d();
      const Ray ray = camera_ray(camera, xi.x, xi.y);
      EXPECT_EQ(ray.origin, camera.position);
      EXPECT_EQ(ray.t_min, camera.near_clip);
      EXPECT_EQ(ray.t_max, camera.far_clip);
      EXPECT_NEAR(length(ray.direction), 1, 4 * 0x1p-53);
      const Vec3 local = camera.camera_to_world.to_local(ray.direction);
      EXPECT_NEAR(local.x / local.z / (corner.x / corner.z), 2 * xi.x - 1, 1e-13);
      EXPECT_NEAR(local.y / local.z / (corner.y / corner.z), 2 * xi.y - 1, 1e-13);
    }
  }
}

}  // namespace
}  // namespace pt::proof
