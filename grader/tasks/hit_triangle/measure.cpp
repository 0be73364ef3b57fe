#include "grader/tasks/hit_triangle/truth.h"
#include "measure/calls/exact.h"
#include "pt/tasks/hit_triangle.h"

namespace measure::calls {

namespace {

using namespace grader::check::hit_triangle_inputs;
using grader::check::rounded;
using pt::Vec3;

constexpr std::uint64_t kSeed = 13;

auto call(const Aimed<pt::Triangle>& aimed) { return pt::hit_triangle(aimed.shape, aimed.ray); }

std::optional<Aimed<pt::Triangle>> make_triangle(pt::Sampler& sampler) {
  const double size = size_between(-6, 6, sampler);
  const Vec3 along = any_direction(sampler);
  const Vec3 across = normalize(cross(along, any_direction(sampler)));
  const Vec3 p0 = in_cube(size * size_between(-2, 3, sampler), sampler);
  const Vec3 p1 = p0 + size * along;
  const Vec3 p2 = p0 + size * (sampler.next_1d() * along + size_between(-3, 0, sampler) * across);
  Aimed<pt::Triangle> aimed;
  const Vec3 n = normalize(cross(along, across));
  const auto corner_normal = [&] { return normalize(n + 0.5 * any_direction(sampler)); };
  aimed.shape = {p0, p1, p2, corner_normal(), corner_normal(), corner_normal()};
  // The point is inside, or beyond an edge.
  const double a = between(-0.5, 1.2, sampler), b = between(-0.5, 1.2, sampler);
  const Vec3 target = p0 + a * (p1 - p0) + b * (p2 - p0);
  const double height = size_between(-3, 0, sampler) * (sampler.next_1d() < 0.5 ? -1 : 1);
  const double turn = between(0, 2 * pt::kPi, sampler);
  const Vec3 flat = std::cos(turn) * along + std::sin(turn) * across;
  const Vec3 from = height * n + std::sqrt(1 - height * height) * flat;
  aimed.ray = ray_towards(target + size * size_between(-1, 3, sampler) * from, target, sampler);
  const Meeting meeting = meet(aimed.shape, aimed.ray);
  const double least = meeting.at.least();
  aimed.hits = least > 0;
  if (!(std::abs(least) > kMargin) || !(meeting.t > 0)) return {};
  return aimed;
}

void look_at_triangle(const Aimed<pt::Triangle>& aimed, const std::optional<pt::SurfaceHit>& hit,
                      Found& found) {
  if (hit.has_value() != aimed.hits) ++found.wrong;
  if (!hit || !aimed.hits) return;
  const pt::Triangle& triangle = aimed.shape;
  const Meeting meeting = meet(triangle, aimed.ray);
  const double step = length(aimed.ray.direction);
  const double largest = std::max({max_abs(triangle.p0), max_abs(triangle.p1), max_abs(triangle.p2),
                                   max_abs(aimed.ray.origin), length(triangle.p1 - triangle.p0),
                                   length(triangle.p2 - triangle.p0), rounded(meeting.t) * step});
  keep_largest(found.errors[0], rounded(hit->t - meeting.t) * step / largest);
  keep_largest(found.errors[1], length(hit->n - normal_at(triangle, meeting.at)));
}

}  // namespace

Subject measure_hit_triangle(int) {
  return exact_subject(make_inputs(kSeed, make_triangle), call, look_at_triangle);
}

}  // namespace measure::calls
