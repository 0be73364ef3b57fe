#pragma once

#include "pt/math/vec3.h"

namespace pt {

// An affine map of space, p -> columns * p + translation, as scene files place their objects.
struct Transform {
  Vec3 x{1, 0, 0};  // the image of the x axis, and so on
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};
  Vec3 translation{};

  Vec3 direction(Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
  Vec3 point(Vec3 p) const { return direction(p) + translation; }

  // Maps a normal with the cofactor matrix (the inverse transpose times the determinant), which
  // exists even if the map is singular. If the map mirrors, the result is turned to the side on
  // which the mapped winding order has the face's own normal. It is not of unit length.
  Vec3 normal(Vec3 n) const { return n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y); }

  double determinant() const { return dot(x, cross(y, z)); }
};

// The map that applies first b, then a.
inline Transform operator*(const Transform& a, const Transform& b) {
  return {a.direction(b.x), a.direction(b.y), a.direction(b.z), a.point(b.translation)};
}

}  // namespace pt
