#pragma once

#include "pt/math/vec3.h"

namespace pt {

// Three corners in world space and a unit normal at each. Seen from the side to which the normal of
// the winding order points (geometric_normal), the corners run anticlockwise. The corner normals
// come from the scene file and need not agree with the winding order.
struct Triangle {
  Vec3 p0, p1, p2;
  Vec3 n0, n1, n2;
};

// The geometric normal. Its length is twice the area, and zero for a degenerate triangle.
inline Vec3 geometric_normal(const Triangle& triangle) {
  return cross(triangle.p1 - triangle.p0, triangle.p2 - triangle.p0);
}

// A flat triangle: all corner normals are the geometric normal.
inline Triangle flat_triangle(Vec3 p0, Vec3 p1, Vec3 p2) {
  const Vec3 n = normalize(cross(p1 - p0, p2 - p0));
  return {p0, p1, p2, n, n, n};
}

}  // namespace pt
