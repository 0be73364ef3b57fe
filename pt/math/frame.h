#pragma once

#include "pt/math/vec3.h"

#include <cmath>

namespace pt {

// Three orthonormal, right-handed axes in world space (cross(x, y) == z). A local vector (a, b, c)
// stands for the world vector a x + b y + c z. The shading frame has z along the normal; the
// camera's has x to the right, y up and z backwards, so that the camera looks along -z.
struct Frame {
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};

  Vec3 to_world(Vec3 local) const { return local.x * x + local.y * y + local.z * z; }
  Vec3 to_local(Vec3 world) const { return {dot(world, x), dot(world, y), dot(world, z)}; }
};

// A frame with the unit vector n as its z axis. It needs no square root, and no branch that loses
// digits near n = -z (Duff et al. 2017, Building an Orthonormal Basis, Revisited, JCGT 6(1)).
inline Frame frame_from_normal(Vec3 n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace pt
