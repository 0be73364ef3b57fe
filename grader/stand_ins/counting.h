#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"

#include <functional>
#include <optional>
#include <vector>

// The implementations `counting` of hit_box, hit_triangle and hit_sphere for the tests of hit_bvh:
// right answers, computed plainly, and a record of everything that was asked. Cost is graded in
// tests per ray, which no machine changes.

namespace grader {

struct Tested {
  std::vector<pt::Box> boxes;
  std::vector<pt::Triangle> triangles;
  std::vector<pt::Sphere> spheres;
  long long answered_here = 0;  // by these implementations; else by the submission's own
};

// What was asked since the last call of forget_tests().
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

// From now on, the test number `tests` (from 1) is interrupted once: before it is answered,
// `interruption` runs from beginning to end in another thread. Where the function under test runs
// in another process, a query of the ray is run there instead.
struct Interruption {
  int tests = 0;
  pt::Ray ray;
  std::function<void(const pt::Ray&)> run;
};
void interrupt(const Interruption& interruption);

// For the implementations themselves: they were asked, and about which ray they have to answer.
pt::Ray asked(const pt::Ray& ray);

// For who sends the answers to another process: from now on nothing is run here, and the ray of an
// interruption that is due has to be taken and sent.
void send_interruptions();
std::optional<pt::Ray> take_interruption();

}  // namespace grader
