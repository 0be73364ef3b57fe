#pragma once

#include "grader/check/generators/generators.h"
#include "pt/geometry/ray.h"
#include "pt/scene/camera.h"

#include <cmath>
#include <limits>
#include <utility>

#include <rapidcheck.h>

// Random cameras, and the way back from a ray to its point of the picture. For camera_ray,
// estimate_pixel and adaptive_pixel.

namespace grader::check {

// A camera with any position and rotation. Its two fields of view are narrow or wide, independently
// of each other.
rc::Gen<pt::Camera> camera();

// The width and height of a picture with more columns or rows than two bytes count, or with more
// pixels than single precision does.
rc::Gen<std::pair<int, int>> many_pixels();

// Returns whether a ray ends where the camera's clip range does, to single precision. A ray has no end
// either if it ends at the largest float or later.
inline bool ends_at(double t_max, double far_clip) {
  return far_clip == pt::kInfinity ? t_max >= std::numeric_limits<float>::max()
                                   : std::abs(t_max - far_clip) <= 1e-6 * far_clip;
}

// Returns where a direction meets the camera's window, which goes from (-1, -1) to (1, 1) between
// the edges of the picture. The result is NaN for a direction behind the camera.
pt::Vec2 on_window(const pt::Camera& camera, pt::Vec3 direction);

// Returns the same point as arguments of camera_ray: (0, 0) is the bottom left corner, (1, 1) the
// top right.
pt::Vec2 on_picture(const pt::Camera& camera, pt::Vec3 direction);

// Returns how far a right ray may be from its point, in pixels. This is the precision of the task
// that chooses the point plus the precision of the submission's own camera_ray.
pt::Vec2 ray_slack(const pt::Camera& camera, int width, int height);

}  // namespace grader::check
