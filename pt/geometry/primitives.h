#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"

#include <optional>
#include <vector>

namespace pt {

// All surfaces of a scene. Primitive i is triangle i; the spheres follow from triangles.size() on.
struct Primitives {
  std::vector<Triangle> triangles;
  std::vector<Sphere> spheres;

  int size() const { return static_cast<int>(triangles.size() + spheres.size()); }
  bool is_triangle(int primitive) const { return primitive < static_cast<int>(triangles.size()); }
  const Triangle& triangle(int primitive) const { return triangles[primitive]; }
  const Sphere& sphere(int primitive) const { return spheres[primitive - triangles.size()]; }
};

inline Box bounds(const Primitives& primitives, int primitive) {
  return primitives.is_triangle(primitive) ? bounds(primitives.triangle(primitive))
                                           : bounds(primitives.sphere(primitive));
}

inline Box bounds(const Primitives& primitives) {
  Box box;
  for (int i = 0; i < primitives.size(); ++i) box.grow(bounds(primitives, i));
  return box;
}

// Calls hit_triangle or hit_sphere, by the kind of the primitive.
inline std::optional<SurfaceHit> hit_primitive(const Primitives& primitives, int primitive,
                                               const Ray& ray) {
  return primitives.is_triangle(primitive) ? hit_triangle(primitives.triangle(primitive), ray)
                                           : hit_sphere(primitives.sphere(primitive), ray);
}

}  // namespace pt
