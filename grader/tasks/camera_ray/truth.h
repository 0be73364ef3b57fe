#pragma once

#include "grader/check/language/exact.h"
#include "pt/scene/camera.h"

#include <cmath>

// The window of a camera, at distance 1 in its frame, and where the rays of a picture meet it.

namespace grader::check::camera_ray_inputs {

inline long double half_tangent(double fov_deg) {
  constexpr long double kHalfDegree = 3.14159265358979323846264338327950288L / 360;
  return std::tan(kHalfDegree * fov_deg);
}

struct Window {
  double width, height;
};

inline Window window_of(const pt::Camera& camera) {
  return {static_cast<double>(2 * half_tangent(camera.hfov_deg)),
          static_cast<double>(2 * half_tangent(camera.vfov_deg))};
}

// The way from the camera to the point (x, y) of the picture on its window.
inline Exact3 to_the_window(const pt::Camera& camera, double x, double y) {
  const pt::Frame& frame = camera.camera_to_world;
  return (2 * Exact(x) - 1) * half_tangent(camera.hfov_deg) * Exact3(frame.x) +
         (2 * Exact(y) - 1) * half_tangent(camera.vfov_deg) * Exact3(frame.y) - Exact3(frame.z);
}

}  // namespace grader::check::camera_ray_inputs
