#pragma once

#include "grader/check/cameras.h"

#include <algorithm>
#include <cmath>

// Cameras from the whole domain, and where rays meet the camera's window.

namespace grader::check::camera_ray_cases {

// The contract's precision: of a point on the window, as a part of its width and height, and of
// everything in single precision.
inline constexpr double kPrecision = 1e-5;
inline constexpr double kSingle = 1e-6;

inline double radians(double degrees) { return degrees * pt::kPi / 180; }

// Ordinary, narrow as a telescope, and as wide as the contract goes.
inline double field_of_view() {
  switch (*whole(0, 4)) {
    case 0:
      return *magnitude(1e-3, 10);
    case 1:
      return *rc::gen::element(90.0, 170.0);
    case 2:
      return *real(120, 170);
    default:
      return *real(10, 120);
  }
}

// At the world's origin, looking along its -z.
inline rc::Gen<pt::Camera> unmoved() {
  return rc::gen::exec([] {
    pt::Camera made;
    made.hfov_deg = field_of_view();
    made.vfov_deg = field_of_view();
    return made;
  });
}

inline pt::Vec3 position() {
  switch (*whole(0, 3)) {
    case 0:
      return {};
    case 1:
      return *magnitude(1e-6, 1e6) * *direction();
    default:
      return *point();
  }
}

// Anywhere, turned in any way or along the axes.
inline rc::Gen<pt::Camera> moved() {
  return rc::gen::exec([] {
    pt::Camera made = *unmoved();
    made.position = position();
    made.camera_to_world = *rotation();
    if (*whole(0, 3) == 0) made.camera_to_world = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    made.near_clip = *rc::gen::element(0.0, 1.0, 1e-6) * *real(0, 2);
    made.far_clip = made.near_clip + *rc::gen::oneOf(magnitude(1e-3, 1e6),
                                                     rc::gen::element(10.0, 1000.0, pt::kInfinity));
    return made;
  });
}

// From one edge of the picture to the other, edges and centre included.
inline double part_of_picture(const char* name) {
  return draw(name, rc::gen::oneOf(real(0, 1), real(0, 1), rc::gen::element(0.0, 0.5, 1.0)));
}

// The size of the window, at distance 1.
struct Window {
  double width, height;
};

inline Window window_of(const pt::Camera& camera) {
  return {2 * std::tan(radians(camera.hfov_deg) / 2), 2 * std::tan(radians(camera.vfov_deg) / 2)};
}

// Where a direction meets the window of an unmoved camera, in front of it or, mirrored, behind.
inline pt::Vec2 on_plane(pt::Vec3 direction) {
  return {direction.x / std::abs(direction.z), direction.y / std::abs(direction.z)};
}

// How far from the right direction (x, y, -1) a ray may be on one axis of the window.
inline double tolerance(double size, pt::Vec2 at) {
  return kPrecision * size + kSingle * (1 + at.x * at.x + at.y * at.y);
}

}  // namespace grader::check::camera_ray_cases
