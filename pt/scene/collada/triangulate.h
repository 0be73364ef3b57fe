#pragma once

#include "pt/math/vec3.h"

#include <span>
#include <vector>

namespace pt {

// A face as triangles: indices of its corners, three by three.
struct Triangulation {
  std::vector<int> corners;
  bool crosses = false;  // the face crosses itself, so that nobody knows what it covers
};

// A face of three corners or more, which need not lie in a plane; nothing for fewer. It is a fan
// around its first corner if that covers the face; else its ears are cut off one by one. A face that
// crosses itself is a fan too.
Triangulation triangulate(std::span<const Vec3> face);

// The same for a face with holes: rings[0] corners of the outline, then rings[i] of each hole, which
// may run either way. A bridge joins each hole to what is around it. If a hole is not inside, or
// the holes are too many, the face crosses, and is shown without holes.
Triangulation triangulate_with_holes(std::span<const Vec3> corners, std::span<const int> rings);

}  // namespace pt
