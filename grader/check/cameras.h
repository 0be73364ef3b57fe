#pragma once

#include "grader/check/generators.h"
#include "pt/geometry/ray.h"
#include "pt/scene/camera.h"

#include <rapidcheck.h>

// Cameras, and the way back from a ray to the picture: for camera_ray, estimate_pixel and
// adaptive_pixel.

namespace grader::check {

// Any position and rotation, narrow and wide fields of view that are not tied to each other.
rc::Gen<pt::Camera> camera();

// Where a direction meets the camera's window, which goes from (-1, -1) to (1, 1) between the edges
// of the picture. NaN behind the camera.
pt::Vec2 on_window(const pt::Camera& camera, pt::Vec3 direction);

// The same as the arguments of camera_ray: (0, 0) is the bottom left corner, (1, 1) the top right.
pt::Vec2 on_picture(const pt::Camera& camera, pt::Vec3 direction);

}  // namespace grader::check
