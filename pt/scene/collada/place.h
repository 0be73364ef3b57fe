#pragma once

#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"
#include "pt/math/transform.h"
#include "pt/scene/collada/geometry.h"

#include <optional>

namespace pt {

// A triangle of a file moved to the world. If the map mirrors, the corners change order, so that
// the geometric normal stays on the same side of the surface. A corner normal that is zero, or
// becomes zero, is replaced by the face's. Nothing if the moved triangle has no area (the square of
// its edges' cross product underflows or overflows).
std::optional<Triangle> place(const FileTriangle& triangle, const Transform& to_world);

// A sphere around the origin moved to the world. Nothing if the map is not a uniform scaling,
// rotation and mirroring: the axes differ in length, or from right angles, by more than 1e-5.
std::optional<Sphere> place_sphere(double radius, const Transform& to_world);

}  // namespace pt
