#include "grader/tasks/hit_sphere/truth.h"
#include "measure/calls/exact.h"
#include "pt/tasks/hit_sphere.h"

namespace measure::calls {

namespace {

using namespace grader::check::hit_sphere_inputs;
using pt::Vec3;

constexpr std::uint64_t kSeed = 13;

// A ray from `distance` radii away that passes the centre at `beside` radii.
Aimed<pt::Sphere> aimed_sphere(double distance, double beside, pt::Sampler& sampler) {
  const double radius = size_between(-3, 3, sampler);
  Aimed<pt::Sphere> aimed;
  aimed.shape = {in_cube(radius * size_between(-1, 2, sampler), sampler), radius};
  const Vec3 away = any_direction(sampler);
  const Vec3 across = normalize(cross(away, any_direction(sampler)));
  const Vec3 origin = aimed.shape.center + distance * radius * away;
  aimed.ray = ray_towards(origin, aimed.shape.center + beside * radius * across, sampler);
  return aimed;
}

std::optional<Aimed<pt::Sphere>> make_sphere(pt::Sampler& sampler) {
  const bool inside = sampler.next_1d() < 0.125;
  const double distance = inside ? between(0, 0.9, sampler) : size_between(0.1, 3, sampler);
  const double beside = inside ? between(0, 0.9, sampler) : 1.5 * std::sqrt(sampler.next_1d());
  Aimed<pt::Sphere> aimed = aimed_sphere(distance, beside, sampler);
  const auto deep = static_cast<double>(depth(aimed.shape, aimed.ray));
  aimed.hits = deep > 0;
  if (!(std::abs(deep) > kMargin)) return {};
  return aimed;
}

auto call(const Aimed<pt::Sphere>& aimed) { return pt::hit_sphere(aimed.shape, aimed.ray); }

void look_at_sphere(const Aimed<pt::Sphere>& aimed, const std::optional<pt::SurfaceHit>& hit,
                    Found& found) {
  if (hit.has_value() != aimed.hits) ++found.wrong;
  if (!hit || !aimed.hits) return;
  const double unit = aimed.shape.radius / length(aimed.ray.direction);
  const auto off_t = grader::check::rounded(hit->t - t_in_front(aimed.shape, aimed.ray));
  keep_largest(found.errors[0], off_t / unit);
  keep_largest(found.errors[1], off(aimed.shape, aimed.ray, *hit).normal);
}

// Here the plain formula loses all digits. A miss counts as the largest error: a radius.
double far_error() {
  constexpr double kFar = 1e7;
  pt::Sampler sampler(kSeed);
  double largest = 0;
  for (int i = 0; i < kInputs; ++i) {
    const auto aimed = aimed_sphere(kFar, 0.9 * std::sqrt(sampler.next_1d()), sampler);
    const auto hit = call(aimed);
    keep_largest(largest, hit ? off(aimed.shape, aimed.ray, *hit).point : 1);
  }
  return largest;
}

}  // namespace

Subject measure_hit_sphere(int) {
  Subject subject = exact_subject(make_inputs(kSeed, make_sphere), call, look_at_sphere);
  subject.find = [near = subject.find](std::uint64_t seed) {
    Found found = near(seed);
    found.errors[2] = far_error();
    return found;
  };
  return subject;
}

}  // namespace measure::calls
