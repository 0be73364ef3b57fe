#pragma once

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/generators/special.h"
#include "grader/tasks/camera_ray/truth.h"
#include "pt/tasks/camera_ray.h"

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
      return *rc::gen::element(90.0, 170.0);
    case 1:
      return *magnitude(1e-3, 10);
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

// Any range. It may be a single distance, and it may have no end.
inline pt::Interval clip_range() {
  const int kind = *whole(0, 2);
  const double near = kind == 0 ? 0 : kind == 1 ? *real(0, 2) : *magnitude(1e-12, 1e12);
  const double way = *whole(0, 1) == 0 ? *magnitude(1e-9, 1e30)
                                       : *rc::gen::element(0.0, 10.0, 1000.0, pt::kInfinity);
  return {near, near + way};
}

// Of five, one has equal fields of view, one has nearly equal ones, and one has any range instead of that of camera_of.
inline rc::Gen<pt::Camera> unmoved() {
  return rc::gen::exec([] {
    const double hfov_deg = field_of_view();
    const int kind = *whole(0, 4);
    const double vfov_deg = kind == 0   ? hfov_deg
                            : kind == 4 ? hfov_deg * (1 - *magnitude(1e-5, 1e-2))
                                        : field_of_view();
    if (kind != 3) return camera_of(hfov_deg, vfov_deg);
    const auto [near, far] = clip_range();
    return camera_of(hfov_deg, vfov_deg, near, far);
  });
}

inline pt::Vec3 position() {
  switch (*whole(0, 3)) {
    case 0:
      return {};
    case 1:
      return *magnitude(1e-12, 1e12) * *direction();
    case 2:
      return *power_of_two(9) * *whole_vector(1);
    default:
      return *point();
  }
}

// A camera anywhere, turned in any way, with any range.
inline rc::Gen<pt::Camera> moved() {
  return rc::gen::exec([] {
    pt::Camera made = *unmoved();
    made.position = position();
    made.camera_to_world = *any_frame();
    if (*whole(0, 3) == 0) made.camera_to_world = axis_frame(*whole(0, kAxisFrames - 1));
    const auto [near, far] = clip_range();
    made.near_clip = near;
    made.far_clip = far;
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

// A point of the picture, with each coordinate from 0 at one edge to 1 at the other. Every third
// point is a corner, the middle of an edge or the centre, and many others are on an edge, or so close
// to it that single precision does not see how close.
inline pt::Vec2 point_of_picture() {
  const auto special = rc::gen::element(0.0, 0.5, 1.0);
  const auto any = rc::gen::oneOf(
      real(0, 1), special, rc::gen::element(5e-324, 1e-9, 0.99999998, 1 - 0x1p-53, 0.5 + 1e-12));
  const auto part = *whole(0, 2) == 0 ? special : any;
  const double x = draw("x", part), y = draw("y", part);
  return {x, y};
}

// A camera and a point of its picture.
struct Aimed {
  pt::Camera camera;
  pt::Vec2 at;
};

inline pt::Ray call(const Aimed& aimed) {
  return pt::camera_ray(aimed.camera, aimed.at.x, aimed.at.y);
}

inline void showValue(const Aimed& aimed, std::ostream& out) {
  out << show(aimed.camera) << "\nx: " << show(aimed.at.x) << "\ny: " << show(aimed.at.y);
}

inline rc::Gen<Aimed> aimed(const rc::Gen<pt::Camera>& camera) {
  return rc::gen::exec([=] {
    const pt::Camera made = *camera;
    return Aimed{made, point_of_picture()};
  });
}

// The same with one number changed, or another frame.
inline Aimed changed(Aimed aimed) {
  auto& [camera, at] = aimed;
  const double size = std::max(1.0, length(camera.position));
  if (*whole(0, 7) == 0) {
    const pt::Frame& f = camera.camera_to_world;
    camera.camera_to_world = {f.y, f.z, f.x};
    return aimed;
  }
  make_one_of(joined({changes_of(camera.position, size),
                      {{&camera.hfov_deg, 0.5 * camera.hfov_deg},
                       {&camera.vfov_deg, 0.5 * camera.vfov_deg},
                       {&camera.near_clip, 0.5 * camera.near_clip},
                       {&camera.far_clip, 2 * camera.far_clip + 1},
                       {&at.x, 1 - 0.5 * at.x},
                       {&at.y, 1 - 0.5 * at.y}}}));
  return aimed;
}

// The same with x and y, the two angles, or two numbers of the position exchanged.
inline Aimed exchanged(Aimed aimed) {
  auto& [camera, at] = aimed;
  const int kind = *whole(0, 2);
  if (kind == 0) std::swap(at.x, at.y);
  if (kind == 1) std::swap(camera.hfov_deg, camera.vfov_deg);
  if (kind == 2) exchange_or_add_in({&camera.position});
  return aimed;
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
