#pragma once

#include "pt/math/vec3.h"

namespace pt {

// The place where a ray meets one surface: the ray parameter t, and the surface's unit normal n
// there, in world space, on the surface's own side (never turned towards the ray).
struct SurfaceHit {
  double t = 0;
  Vec3 n;
};

// A SurfaceHit, and the primitive that was hit: an index into Primitives.
struct Hit {
  double t = 0;
  Vec3 n;
  int primitive = 0;
};

}  // namespace pt
