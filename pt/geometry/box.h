#pragma once

#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"
#include "pt/math/vec3.h"

namespace pt {

// An axis-parallel box in world space: the points p with min <= p <= max in every component. It may
// be flat. A new box is empty: it holds nothing, and growing it by a point makes it that point.
struct Box {
  Vec3 min{kInfinity, kInfinity, kInfinity};
  Vec3 max{-kInfinity, -kInfinity, -kInfinity};

  void grow(Vec3 p) {
    min = pt::min(min, p);
    max = pt::max(max, p);
  }
  void grow(const Box& other) {
    min = pt::min(min, other.min);
    max = pt::max(max, other.max);
  }

  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  Vec3 center() const { return 0.5 * (min + max); }
  Vec3 extent() const { return max - min; }
};

inline Box bounds(const Triangle& triangle) {
  Box box;
  box.grow(triangle.p0);
  box.grow(triangle.p1);
  box.grow(triangle.p2);
  return box;
}

inline Box bounds(const Sphere& sphere) {
  const Vec3 r{sphere.radius, sphere.radius, sphere.radius};
  return {sphere.center - r, sphere.center + r};
}

}  // namespace pt
