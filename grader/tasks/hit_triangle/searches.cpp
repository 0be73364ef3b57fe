#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/exact.h"
#include "grader/tasks/hit_triangle/inputs.h"
#include "pt/tasks/hit_triangle.h"

namespace grader::check {
namespace {

using namespace hit_triangle_inputs;

// The point in which the ray meets the triangle's plane.
struct Meeting {
  Exact t = 0, b0 = 0, b1 = 0, b2 = 0;

  double least() const { return std::min({rounded(b0), rounded(b1), rounded(b2)}); }
};

Meeting meet(const pt::Triangle& triangle, const pt::Ray& ray) {
  const Exact3 p0 = triangle.p0, d = ray.direction;
  const Exact3 e1 = Exact3(triangle.p1) - p0, e2 = Exact3(triangle.p2) - p0;
  const Exact3 s = Exact3(ray.origin) - p0, h = cross(d, e2), q = cross(s, e1);
  const Exact determinant = dot(e1, h);
  const Exact b1 = dot(s, h) / determinant, b2 = dot(d, q) / determinant;
  return {dot(e2, q) / determinant, 1 - b1 - b2, b1, b2};
}

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
  show_case(aimed.triangle, aimed.ray);
  const Meeting meeting = meet(aimed.triangle, aimed.ray);
  if (!(meeting.least() > slack(aimed))) return 0;
  const auto hit = pt::hit_triangle(aimed.triangle, aimed.ray);
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
          const pt::Vec3 n = normalize(rounded(m.b0 * Exact3(aimed.triangle.n0) +
                                               m.b1 * Exact3(aimed.triangle.n1) +
                                               m.b2 * Exact3(aimed.triangle.n2)));
          return length(hit.n - n) / aimed.n_tolerance;
        });
      }};
}

SEARCH(hit_triangle, outside) {
  return {.title = "a ray beside a triangle that hits: how far outside it is",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Aimed out = (*aimed_outside(kEverything, barely_outside)).out;
            show_case(out.triangle, out.ray);
            const double beside = -meet(out.triangle, out.ray).least() / slack(out);
            if (pt::hit_triangle(out.triangle, out.ray)) return std::max(beside, 0.0);
            // The badness is nearly one, so that the search goes on towards the edge.
            return beside > 0 ? 1e-3 / (1 + beside) : 0;
          }};
}

}  // namespace
}  // namespace grader::check
