#pragma once

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Cameras of all kinds that the contract allows, and the points where rays meet a camera's window.

namespace grader::check::camera_ray_inputs {

// The contract's precision. kPrecision is for a point on the window, relative to the window's width
// and height. kSingle is for everything in single precision.
inline constexpr double kPrecision = 1e-5;
inline constexpr double kSingle = 1e-6;

inline double radians(double degrees) { return degrees * pt::kPi / 180; }

// An ordinary angle, an angle as narrow as in a telescope, or a wide one up to the contract's
// limit.
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

// A camera at the world's origin that looks along the world's -z.
inline pt::Camera camera_of(double hfov_deg, double vfov_deg, double near = 0,
                            double far = pt::kInfinity) {
  return {{}, {}, hfov_deg, vfov_deg, near, far};
}

inline rc::Gen<pt::Camera> unmoved() {
  return rc::gen::exec([] {
    const double hfov_deg = field_of_view(), vfov_deg = field_of_view();
    return camera_of(hfov_deg, vfov_deg);
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

// The frames whose axes are those of the world, in any order and direction: 0 to 23.
inline constexpr int kAxisFrames = 24;
inline pt::Frame axis_frame(int number) {
  pt::Vec3 x, y;
  const int axis = number % 3, other = (axis + 1 + number / 3 % 2) % 3;
  x[axis] = number / 6 % 2 == 0 ? 1 : -1;
  y[other] = number / 12 == 0 ? 1 : -1;
  return {x, y, cross(x, y)};
}

// A camera anywhere, turned by any rotation or along the axes. Its range may be a single point.
inline rc::Gen<pt::Camera> moved() {
  return rc::gen::exec([] {
    pt::Camera made = *unmoved();
    made.position = position();
    made.camera_to_world = *rotation();
    if (*whole(0, 3) == 0) made.camera_to_world = axis_frame(*whole(0, kAxisFrames - 1));
    made.near_clip =
        *rc::gen::element(0.0, 1.0, 1e-6) * *rc::gen::oneOf(real(0, 2), magnitude(1, 1e6));
    made.far_clip =
        made.near_clip +
        *rc::gen::oneOf(magnitude(1e-3, 1e12), rc::gen::element(0.0, 10.0, 1000.0, pt::kInfinity));
    return made;
  });
}

inline rc::Gen<pt::Camera> along_the_axes(int number) {
  return rc::gen::exec([=] {
    pt::Camera made = *moved();
    made.camera_to_world = axis_frame(number);
    return made;
  });
}

// The following cameras are fixed.

// Their range, where it does not matter.
inline constexpr double kNear = 0.25, kFar = 40;

// Ordinary fields of view, each of them unmoved and moved.
inline std::vector<pt::Camera> ordinary() {
  constexpr std::array<double, 2> kAngles[] = {{50, 38}, {90, 30}, {20, 70}, {100, 100}};
  RandomNumbers make(2);
  std::vector<pt::Camera> all;
  for (const auto& [horizontal, vertical] : kAngles) {
    pt::Camera camera = camera_of(horizontal, vertical, kNear, kFar);
    all.push_back(camera);
    camera.position = make.vector(-4, 4);
    const pt::Frame around = pt::frame_from_normal(normalize(make.vector(-1, 1)));
    camera.camera_to_world = {around.z, around.x, around.y};
    all.push_back(camera);
  }
  return all;
}

// Fields of view that are narrow, wide, or not in whole degrees. The last one has a range without
// an end, so that its other numbers are about as large as a direction, and a small error of an
// angle shows.
inline std::vector<pt::Camera> unusual() {
  return {camera_of(0.5, 0.4, kNear, kFar), camera_of(175, 170, kNear, kFar),
          camera_of(86.3, 60.7, kNear)};
}

// Ranges that end at a billion, that begin at 20, and that are a single distance.
inline std::vector<pt::Camera> with_ranges() {
  return {camera_of(50, 38, kNear, 1e9), camera_of(50, 38, 20, 40), camera_of(50, 38, 2, 2)};
}

// Cameras that look straight up and straight down. The right side of their picture is along the
// world's z.
inline std::vector<pt::Camera> upright() {
  std::vector<pt::Camera> all(2, camera_of(50, 38, kNear, kFar));
  all[0].camera_to_world = axis_frame(14);
  all[1].camera_to_world = axis_frame(2);
  return all;
}

// Points of the picture: its centre, the middles of its edges, and others.
inline constexpr std::array<double, 2> kPlaces[] = {{.5, .5}, {0, .5},  {1, .5}, {.5, 0},
                                                    {.5, 1},  {.1, .8}, {1, 1},  {.7, .35}};

// A coordinate on the picture, from 0 at one edge to 1 at the other, often an edge or the centre.
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

// Returns where a direction meets the window of an unmoved camera. A direction that points
// backwards is mirrored to the front.
inline pt::Vec2 on_plane(pt::Vec3 direction) {
  return {direction.x / std::abs(direction.z), direction.y / std::abs(direction.z)};
}

// Returns how far a ray may be from the right direction (x, y, -1), on one axis of the window.
inline double tolerance(double size, pt::Vec2 at) {
  return kPrecision * size + kSingle * (1 + at.x * at.x + at.y * at.y);
}

}  // namespace grader::check::camera_ray_inputs
