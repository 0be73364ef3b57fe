#include "grader/property/cameras.h"
#include "grader/property/property.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace grader {
namespace {

double radians(double degrees) { return degrees * pt::kPi / 180; }

// Rounding in a rotation and a tangent, some hundred times over.
constexpr double kTolerance = 1e-12;

double along() { return draw("x", real(0, 1)); }
double upwards() { return draw("y", real(0, 1)); }

// The angle between two unit vectors: exact where it is small too.
double angle_between(pt::Vec3 a, pt::Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

PROMISE(camera_ray, starts_at_the_camera) {
  for_all([] {
    const pt::Camera c = *camera();
    const pt::Ray ray = pt::camera_ray(c, along(), upwards());
    expect_near("the origin", ray.origin, c.position, 0);
  });
}

PROMISE(camera_ray, has_a_unit_direction) {
  for_all([] {
    const pt::Camera c = *camera();
    const pt::Ray ray = pt::camera_ray(c, along(), upwards());
    expect_near("the length of the direction", length(ray.direction), 1, kTolerance);
  });
}

PROMISE(camera_ray, looks_along_minus_z) {
  for_all([] {
    const pt::Camera c = *camera();
    const pt::Ray ray = pt::camera_ray(c, 0.5, 0.5);
    expect_near("the direction through the centre", ray.direction, -c.camera_to_world.z,
                kTolerance);
  });
}

PROMISE(camera_ray, fills_the_field_of_view) {
  for_all([] {
    const pt::Camera c = *camera();
    const pt::Vec3 ahead = -c.camera_to_world.z;
    const double half_width = radians(c.hfov_deg) / 2, half_height = radians(c.vfov_deg) / 2;
    const auto angle = [&](double x, double y) {
      const pt::Vec3 d = pt::camera_ray(c, x, y).direction;
      return angle_between(d / length(d), ahead);
    };
    expect_near("radians to the left edge", angle(0, 0.5), half_width, kTolerance);
    expect_near("radians to the right edge", angle(1, 0.5), half_width, kTolerance);
    expect_near("radians to the bottom edge", angle(0.5, 0), half_height, kTolerance);
    expect_near("radians to the top edge", angle(0.5, 1), half_height, kTolerance);
  });
}

PROMISE(camera_ray, puts_x_to_the_right_and_y_up) {
  for_all([] {
    const pt::Camera c = *camera();
    const double x = along(), y = upwards();
    const pt::Vec3 local = c.camera_to_world.to_local(pt::camera_ray(c, x, y).direction);
    const double off_x = x - 0.5, off_y = y - 0.5;
    expect(off_x == 0 || local.x * off_x > 0, "to the side of the picture that x is on",
           show(local) + " in the camera's frame");
    expect(off_y == 0 || local.y * off_y > 0, "to the side of the picture that y is on",
           show(local) + " in the camera's frame");
  });
}

PROMISE(camera_ray, keeps_the_picture_flat) {
  for_all([] {
    const pt::Camera c = *camera();
    const double x = along(), y = upwards();
    const pt::Vec2 at = on_picture(c, pt::camera_ray(c, x, y).direction);
    expect_near("the point on the window, from its left edge", at.x, x, kTolerance);
    expect_near("the point on the window, from its bottom edge", at.y, y, kTolerance);
  });
}

PROMISE(camera_ray, turns_with_the_camera) {
  for_all([] {
    const pt::Camera c = *camera();
    pt::Camera at_origin = c;
    at_origin.position = {};
    at_origin.camera_to_world = {};
    const double x = along(), y = upwards();
    const pt::Vec3 direction = pt::camera_ray(c, x, y).direction;
    const pt::Vec3 unturned = pt::camera_ray(at_origin, x, y).direction;
    expect_near("the direction in the camera's frame", c.camera_to_world.to_local(direction),
                unturned, kTolerance);
    // A direction that ignores both the frame and the picture is the same everywhere as well.
    const pt::Vec2 at = on_picture(at_origin, unturned);
    expect_near("the point on the window of a camera at the origin", pt::Vec3{at.x, at.y, 0},
                pt::Vec3{x, y, 0}, kTolerance);
  });
}

PROMISE(camera_ray, keeps_the_clip_range) {
  for_all([] {
    const pt::Camera c = *camera();
    const pt::Ray ray = pt::camera_ray(c, along(), upwards());
    expect_near("t_min", ray.t_min, c.near_clip, 0);
    expect(ray.t_max == c.far_clip, "t_max " + show(c.far_clip), "t_max " + show(ray.t_max));
  });
}

}  // namespace
}  // namespace grader
