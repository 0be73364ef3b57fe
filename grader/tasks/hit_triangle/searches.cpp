#include "grader/check/language/bad_inputs.h"
#include "grader/tasks/hit_triangle/inputs.h"

namespace grader::check {
namespace {

using namespace hit_triangle_inputs;

// The largest error that the contract allows.
constexpr Range kEverything{.size = 1e6,
                            .speed = 1e9,
                            .thin = 1e-6,
                            .thick = 1,
                            .away = 1e3,
                            .near = 1e-2,
                            .far = 1e3,
                            .flat = 1e-6};

// The contract's precision of a point in the plane, as a difference of weights: in units of the
// smallest height of the triangle.
double slack(const Aimed& aimed) {
  const double longest = std::max({length(aimed.triangle.p1 - aimed.triangle.p0),
                                   length(aimed.triangle.p2 - aimed.triangle.p1),
                                   length(aimed.triangle.p0 - aimed.triangle.p2)});
  const double height = length(geometric_normal(aimed.triangle)) / longest;
  return aimed.tolerance * length(aimed.ray.direction) / height;
}

// A ray that has to hit by the contract, and the point. Nothing if the point may lie outside.
double badness_inside(double (*of)(const Aimed&, const Meeting&, const pt::SurfaceHit&)) {
  const Aimed aimed = *aimed_inside(kEverything);
  show_case(aimed);
  const Meeting meeting = meet(aimed.triangle, aimed.ray);
  if (!(meeting.at.least() > slack(aimed))) return 0;
  const auto hit = call(aimed);
  return hit ? of(aimed, meeting, *hit) : kBroken;
}

SEARCH(hit_triangle, t) {
  return {.title = "a ray at a point inside a triangle: how far t is off",
          .measure = "1 is what the contract allows",
          .badness = [] {
            return badness_inside(
                [](const Aimed& aimed, const Meeting& meeting, const pt::SurfaceHit& hit) {
                  return std::abs(rounded(Exact(hit.t) - meeting.t)) / aimed.tolerance;
                });
          }};
}

SEARCH(hit_triangle, n) {
  return {
      .title = "a ray at a point inside a triangle: how far the normal is off",
      .measure = "1 is what the contract allows",
      .badness = [] {
        return badness_inside([](const Aimed& aimed, const Meeting& m, const pt::SurfaceHit& hit) {
          const Exact3 n = normal_at(aimed.triangle, m.at);
          return static_cast<double>(length(hit.n - n)) / aimed.n_tolerance;
        });
      }};
}

SEARCH(hit_triangle, outside) {
  return {.title = "a ray beside a triangle that hits: how far outside it is",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Aimed out = *aims(kEverything, barely_outside);
            show_case(out);
            const double beside = -meet(out.triangle, out.ray).at.least() / slack(out);
            if (call(out)) return std::max(beside, 0.0);
            // The badness is nearly one, so that the search goes on towards the edge.
            return beside > 0 ? 1e-3 / (1 + beside) : 0;
          }};
}

}  // namespace
}  // namespace grader::check
