#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"
#include "writeup/measure/draw.h"
#include "writeup/measure/exact.h"
#include "writeup/measure/precise.h"

#include <array>

namespace writeup::measure {

namespace {

using pt::Ray;
using pt::SurfaceHit;
using pt::Vec3;

constexpr std::uint64_t kSeed = 13;
constexpr long double kMargin = 0.01L;  // of barycentric coordinates, and of a radius: no borders

template <class Shape>
struct Aimed {
  Shape shape;
  Ray ray;
  bool hits = false;
};

// Towards `target`, its direction of any length.
Ray ray_towards(Vec3 origin, Vec3 target, pt::Sampler& sampler) {
  Ray ray;
  ray.origin = origin;
  ray.direction = size_between(-3, 3, sampler) * normalize(target - origin);
  return ray;
}

struct Meeting {
  long double t = 0;
  std::array<long double, 3> weights{};  // of the corners; they sum to 1
};

// The point where the ray meets the triangle's plane.
Meeting meet(const pt::Triangle& triangle, const Ray& ray) {
  const Precise3 p0 = triangle.p0;
  const Precise3 n = cross(Precise3(triangle.p1) - p0, Precise3(triangle.p2) - p0);
  const long double t = dot(p0 - ray.origin, n) / dot(ray.direction, n);
  const Precise3 p = Precise3(ray.origin) + t * Precise3(ray.direction);
  const auto weight = [&](Vec3 a, Vec3 b) {
    return dot(cross(Precise3(a) - p, Precise3(b) - p), n) / dot(n, n);
  };
  return {t,
          {weight(triangle.p1, triangle.p2), weight(triangle.p2, triangle.p0),
           weight(triangle.p0, triangle.p1)}};
}

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
  // Inside, or beyond an edge.
  const double a = between(-0.5, 1.2, sampler), b = between(-0.5, 1.2, sampler);
  const Vec3 target = p0 + a * (p1 - p0) + b * (p2 - p0);
  const double height = size_between(-3, 0, sampler) * (sampler.next_1d() < 0.5 ? -1 : 1);
  const double turn = between(0, 2 * pt::kPi, sampler);
  const Vec3 flat = std::cos(turn) * along + std::sin(turn) * across;
  const Vec3 from = height * n + std::sqrt(1 - height * height) * flat;
  aimed.ray = ray_towards(target + size * size_between(-1, 3, sampler) * from, target, sampler);
  const Meeting meeting = meet(aimed.shape, aimed.ray);
  const long double least = *std::min_element(meeting.weights.begin(), meeting.weights.end());
  aimed.hits = least > 0;
  if (!(std::abs(least) > kMargin) || !(meeting.t > 0)) return {};
  return aimed;
}

void look_at_triangle(const Aimed<pt::Triangle>& aimed, const std::optional<SurfaceHit>& hit,
                      Found& found) {
  if (hit.has_value() != aimed.hits) ++found.wrong;
  if (!hit || !aimed.hits) return;
  const pt::Triangle& triangle = aimed.shape;
  const Meeting meeting = meet(triangle, aimed.ray);
  const long double step = length(aimed.ray.direction);
  const long double largest = std::max<long double>(
      {max_abs(triangle.p0), max_abs(triangle.p1), max_abs(triangle.p2), max_abs(aimed.ray.origin),
       length(triangle.p1 - triangle.p0), length(triangle.p2 - triangle.p0), meeting.t * step});
  keep_largest(found.errors[0], (hit->t - meeting.t) * step / largest);
  const Precise3 n = normalize(meeting.weights[0] * Precise3(triangle.n0) +
                               meeting.weights[1] * Precise3(triangle.n1) +
                               meeting.weights[2] * Precise3(triangle.n2));
  keep_largest(found.errors[1], length(Precise3(hit->n) - n));
}

// Seen from `distance` radii away, past the centre at `beside` radii.
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

// So far away that the plain formula loses all digits. A miss counts as the largest error: a radius.
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

Subject triangles() {
  return exact_subject(
      make_inputs(kSeed, make_triangle),
      [](const Aimed<pt::Triangle>& aimed) { return pt::hit_triangle(aimed.shape, aimed.ray); },
      look_at_triangle);
}

Subject spheres() {
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

}  // namespace writeup::measure
