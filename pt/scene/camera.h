#pragma once

#include "pt/math/frame.h"
#include "pt/math/vec3.h"

namespace pt {

// A pinhole camera. The frame has x to the right of the picture, y up and z backwards: the camera
// looks along -z of its own frame. The fields of view are whole angles between opposite edges of
// the picture, in degrees, as in scene files and in photography.
struct Camera {
  Vec3 position;  // world space
  Frame camera_to_world;
  double hfov_deg = 50;  // horizontal, in (0, 180)
  double vfov_deg = 38;  // vertical; not tied to the horizontal one by any aspect ratio
  double near_clip = 0;  // nothing closer than this is seen, along the ray
  double far_clip = kInfinity;
};

}  // namespace pt
