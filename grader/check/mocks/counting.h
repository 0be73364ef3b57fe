#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"

#include <optional>
#include <vector>

// The counting versions of hit_box, hit_triangle and hit_sphere for the properties of hit_bvh
// (implementation `counting`). They compute right answers in a plain way and record every call.
// Cost is graded in tests per ray, which are the same on every machine.

namespace grader::check {

struct Tested {
  std::vector<pt::Box> boxes;
  std::vector<pt::Triangle> triangles;
  std::vector<pt::Sphere> spheres;
  long long answered_here = 0;  // calls that these versions answered, not the submission's own
};

// All tests since the last forget_tests().
const Tested& tested();
void forget_tests();

// Records one test.
void count(const pt::Box& box);
void count(const pt::Triangle& triangle);
void count(const pt::Sphere& sphere);

// From now on, every test is answered for the other ray, in the range of the ray in the call. A
// query that computes intersections itself, without these tests, then finds something else. Without
// another ray, tests are answered for the ray in the call.
void answer_for(const std::optional<pt::Ray>& other);

// For the implementations: records the call, and returns the ray for which they have to answer.
pt::Ray asked(const pt::Ray& ray);

}  // namespace grader::check
