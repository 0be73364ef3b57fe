#include "grader/check/language/bad_inputs.h"
#include "grader/tasks/hit_sphere/inputs.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace hit_sphere_inputs;

double badness_of(const Chord& c) {
  show_case(c);
  const auto hit = call(c);
  expect(hit.has_value(), "a hit", "no hit");
  const auto [point, normal] = off(c, *hit);
  return std::max(point, normal) / kPrecision;
}

SEARCH(hit_sphere, hits) {
  return {.title = "a ray at a sphere, from outside and inside, at most a thousand radii away",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const bool outside = *whole(0, 1) == 0;
            // Inside, a flatter chord has no room for the ray's origin.
            const Domain domain{
                .radius = 1e5, .speed = 1e9, .flat = outside ? 3e-4 : kFlat, .far = kFar};
            return badness_of(*chord(outside ? From::outside : From::inside, domain));
          }};
}

SEARCH(hit_sphere, any_distance) {
  return {.title = "a ray at a sphere up to ten million radii away (a bonus)",
          .measure = "1 is what the contract allows",
          .badness = [] { return badness_of(*aimed_from(1e3, 1e7)); }};
}

SEARCH(hit_sphere, beside) {
  return {.title = "a ray that passes a sphere: how far beside it hits",
          .measure = "1 is what the contract allows: 1e-8 radii",
          .badness = [] {
            const Chord c = *passing(1e-10, 1e-7, kFar);
            show_case(c);
            const double squared = -rounded(depth(c.sphere, c.ray));
            const double beside = squared / (1 + std::sqrt(1 + squared)) / kTouching;
            const bool hit = call(c).has_value();
            if (beside <= 0) return 0.0;
            return hit ? beside : 1e-3 / (1 + beside);
          }};
}

}  // namespace
}  // namespace grader::check
