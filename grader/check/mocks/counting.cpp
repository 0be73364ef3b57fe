#include "grader/check/mocks/counting.h"

namespace grader::check {

namespace {

Tested record;
std::optional<pt::Ray> other_ray;

}  // namespace

const Tested& tested() { return record; }

void forget_tests() { record = {}; }

void count(const pt::Box& box) { record.boxes.push_back(box); }
void count(const pt::Triangle& triangle) { record.triangles.push_back(triangle); }
void count(const pt::Sphere& sphere) { record.spheres.push_back(sphere); }

void answer_for(const std::optional<pt::Ray>& other) { other_ray = other; }

pt::Ray asked(const pt::Ray& ray) {
  ++record.answered_here;
  if (!other_ray) return ray;
  return {other_ray->origin, other_ray->direction, ray.t_min, ray.t_max};
}

}  // namespace grader::check
