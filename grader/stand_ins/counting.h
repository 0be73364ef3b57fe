#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"

#include <vector>

// The implementations `counting` of hit_box, hit_triangle and hit_sphere for the tests of hit_bvh:
// right answers, computed plainly, and a record of everything that was asked. Cost is graded in
// tests a ray, which no machine changes.

namespace grader {

struct Tested {
  std::vector<pt::Box> boxes;
  std::vector<pt::Triangle> triangles;
  std::vector<pt::Sphere> spheres;
};

// What was asked since the last call of forget_tests().
const Tested& tested();
void forget_tests();

// For the stand-ins themselves.
void count(const pt::Box& box);
void count(const pt::Triangle& triangle);
void count(const pt::Sphere& sphere);

}  // namespace grader
