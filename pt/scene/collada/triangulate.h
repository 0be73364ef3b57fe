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

}  // namespace pt
