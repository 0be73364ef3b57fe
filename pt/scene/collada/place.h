#pragma once

#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"
#include "pt/math/transform.h"
#include "pt/scene/collada/geometry.h"

#include <optional>

namespace pt {

// A triangle of a file moved to the world. Turned round where the map mirrors, so that its
// geometric normal stays on the same side of the surface. A corner normal that is zero, or becomes
// so, is the face's. Nothing where the moved triangle has no area (no cross product of its edges
// whose square a double can hold).
std::optional<Triangle> place(const FileTriangle& triangle, const Transform& to_world);

// A sphere around the origin moved to the world; nothing where the map is not a uniform scaling,
// rotation and mirroring: axes of different length, or not at right angles, by more than 1e-5.
std::optional<Sphere> place_sphere(double radius, const Transform& to_world);

}  // namespace pt
