#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"

#include <optional>
#include <vector>

// The implementations `counting` of hit_box, hit_triangle and hit_sphere for the tests of hit_bvh:
// right answers, computed plainly, and a record of everything that was asked. Cost is graded in
// tests per ray, which no machine changes.

namespace grader::check {

struct Tested {
  std::vector<pt::Box> boxes;
  std::vector<pt::Triangle> triangles;
  std::vector<pt::Sphere> spheres;
  long long answered_here = 0;  // by these implementations; else by the submission's own
};

// The tests that were called since the last forget_tests().
const Tested& tested();
void forget_tests();

// For those who know that a test was made.
void count(const pt::Box& box);
void count(const pt::Triangle& triangle);
void count(const pt::Sphere& sphere);

// From now on every test is answered for the other ray, in the range of the ray that is asked
// about: whoever computes intersections without asking finds something else. Without one, for the
// ray itself.
void answer_for(const std::optional<pt::Ray>& other);

// For the implementations themselves: notes the call, and returns the ray for which they have to
// answer.
pt::Ray asked(const pt::Ray& ray);

}  // namespace grader::check
