#pragma once

#include "pt/math/vec3.h"

namespace pt {

// The surface of a ball, in world space; radius > 0. Its normal points outwards.
struct Sphere {
  Vec3 center;
  double radius = 1;
};

}  // namespace pt
