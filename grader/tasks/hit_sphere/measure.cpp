#include "measure/calls/exact.h"
#include "measure/calls/subject.h"
#include "pt/tasks/hit_sphere.h"

#include <array>

namespace measure::calls {

namespace {

using pt::SurfaceHit;
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

// The part of the quadratic equation's discriminant that says how near the ray passes, in radii^2.
long double depth2(const Aimed<pt::Sphere>& aimed) {
  const Precise3 to_center = Precise3(aimed.shape.center) - aimed.ray.origin;
  const Precise3 past = cross(normalize(Precise3(aimed.ray.direction)), to_center);
  const long double radius = aimed.shape.radius;
  return 1 - dot(past, past) / (radius * radius);
}

long double true_t(const Aimed<pt::Sphere>& aimed) {
  const Precise3 to_center = Precise3(aimed.shape.center) - aimed.ray.origin;
  const Precise3 d = aimed.ray.direction;
  const long double radius = aimed.shape.radius, step = length(d);
  const long double middle = dot(to_center, d) / (step * step);
  const long double half = radius * std::sqrt(depth2(aimed)) / step;
  return middle - half > 0 ? middle - half : middle + half;
}

std::optional<Aimed<pt::Sphere>> make_sphere(pt::Sampler& sampler) {
  const bool inside = sampler.next_1d() < 0.125;
  const double distance = inside ? between(0, 0.9, sampler) : size_between(0.1, 3, sampler);
  const double beside = inside ? between(0, 0.9, sampler) : 1.5 * std::sqrt(sampler.next_1d());
  Aimed<pt::Sphere> aimed = aimed_sphere(distance, beside, sampler);
  aimed.hits = depth2(aimed) > 0;
  if (!(std::abs(depth2(aimed)) > kMargin)) return {};
  return aimed;
}

// The errors of the point at t, and of the normal there, in radii.
std::array<long double, 2> errors_at(const Aimed<pt::Sphere>& aimed, const SurfaceHit& hit) {
  const long double t = hit.t, radius = aimed.shape.radius;
  const Precise3 p = Precise3(aimed.ray.origin) + t * Precise3(aimed.ray.direction);
  const Precise3 from_center = p - aimed.shape.center;
  return {length(from_center) / radius - 1, length(Precise3(hit.n) - normalize(from_center))};
}

void look_at_sphere(const Aimed<pt::Sphere>& aimed, const std::optional<SurfaceHit>& hit,
                    Found& found) {
  if (hit.has_value() != aimed.hits) ++found.wrong;
  if (!hit || !aimed.hits) return;
  const long double step = length(aimed.ray.direction);
  keep_largest(found.errors[0], (hit->t - true_t(aimed)) * step / aimed.shape.radius);
  keep_largest(found.errors[1], errors_at(aimed, *hit)[1]);
}

// Here the plain formula loses all digits. A miss counts as the largest error: a radius.
double far_error() {
  constexpr double kFar = 1e7;
  pt::Sampler sampler(kSeed);
  double largest = 0;
  for (int i = 0; i < kInputs; ++i) {
    const auto aimed = aimed_sphere(kFar, 0.9 * std::sqrt(sampler.next_1d()), sampler);
    const std::optional<SurfaceHit> hit = pt::hit_sphere(aimed.shape, aimed.ray);
    keep_largest(largest, hit ? errors_at(aimed, *hit)[0] : 1);
  }
  return largest;
}

}  // namespace

Subject measure_hit_sphere(int) {
  Subject subject = exact_subject(
      make_inputs(kSeed, make_sphere),
      [](const Aimed<pt::Sphere>& aimed) { return pt::hit_sphere(aimed.shape, aimed.ray); },
      look_at_sphere);
  subject.find = [near = subject.find](std::uint64_t seed) {
    Found found = near(seed);
    found.errors[2] = far_error();
    return found;
  };
  return subject;
}

}  // namespace measure::calls
