#pragma once

#include "pt/math/frame.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

namespace pt {

// A point on a surface as light transport sees it, in world space; surface_point()
// in pt/scene/scene.h makes it from a hit. Surfaces reflect on both sides, so n is turned to the side
// that the ray came from.
struct SurfacePoint {
  Vec3 p;
  Vec3 n;                 // unit shading normal, on wo's side: dot(n, wo) >= 0
  Vec3 geometric_normal;  // unit, of the true surface, not turned
  Frame frame;            // z is n
  Vec3 wo;                // unit, pointing away from the surface, to where the ray came from
  Rgb albedo;             // in [0, 1]
  Rgb emission;           // emitted radiance along wo
  int triangle = -1;      // index of the triangle that p is on; -1: p is on a sphere
  double scale = 1;  // the size of the numbers that p was computed from, for its rounding error
};

}  // namespace pt
