// right: of a rectangle, every direction in which it is seen is equally likely.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pt {

namespace {

// A light that looks smaller has no noise that would be worth the digits.
constexpr double kSmallSolidAngle = 1e-6;
constexpr double kRightAngle = 1e-9;  // cosine

// A rectangle as it is seen from a point: a piece of the unit sphere around the point. Its
// directions can be drawn uniformly, with density 1 / solid_angle per steradian (Ureña, Fajardo and
// King 2013, An Area-Preserving Parametrization for Spherical Rectangles).
//
// Seen from the point, x and y run along the sides and z towards the rectangle's plane, so that the
// rectangle is at x0 <= x <= x1, y0 <= y <= y1, z = z0. A cylinder around the y axis has the same
// area as the sphere in it, piece by piece (Archimedes): the angle phi around the axis, with
// tan phi = x / z0, and the height h = y / distance are coordinates in which areas are kept,
// dphi dh. At the angle phi, the rectangle reaches from h(y0) to h(y1). Between phi = 0 and phi it
// fills
//   area(phi) = asin(b1 sin phi) - asin(b0 sin phi),  b = y / sqrt(y^2 + z0^2),
// where asin(b sin phi) = atan(x y / (z0 sqrt(x^2 + y^2 + z0^2))), which keeps its digits near 1.
struct SphericalRectangle {
  Vec3 x, y, z;  // unit, world space
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0, z0 = 0;
  double b0 = 0, b1 = 0;
  double area0 = 0;        // area(phi) where x = x0; negative if x0 < 0
  double solid_angle = 0;  // zero where the point is in the plane
};

// The rectangle center + (a - 1/2) u + (b - 1/2) v, a and b in [0, 1], as seen from p; u and v are
// perpendicular and not zero. It may have any size and position. The absolute error of the solid
// angle is about 1e-15, so a rectangle with a smaller solid angle has no correct digit.
SphericalRectangle spherical_rectangle(Vec3 p, Vec3 center, Vec3 u, Vec3 v) {
  SphericalRectangle seen;
  const double width = length(u), height = length(v);
  seen.x = u / width;
  seen.y = v / height;
  seen.z = cross(seen.x, seen.y);
  const Vec3 to_center = center - p;
  seen.x0 = dot(to_center, seen.x) - 0.5 * width;
  seen.x1 = seen.x0 + width;
  seen.y0 = dot(to_center, seen.y) - 0.5 * height;
  seen.y1 = seen.y0 + height;
  seen.z0 = dot(to_center, seen.z);
  if (seen.z0 < 0) {
    seen.z = -seen.z;
    seen.z0 = -seen.z0;
  }
  if (!(seen.z0 > 0)) return seen;

  seen.b0 = seen.y0 / std::sqrt(seen.y0 * seen.y0 + seen.z0 * seen.z0);
  seen.b1 = seen.y1 / std::sqrt(seen.y1 * seen.y1 + seen.z0 * seen.z0);
  // The difference of two such angles is the angle between two vectors of the plane.
  const auto area = [&](double x) {
    const double flat = x * x + seen.z0 * seen.z0;
    const double across0 = seen.z0 * std::sqrt(flat + seen.y0 * seen.y0), along0 = x * seen.y0;
    const double across1 = seen.z0 * std::sqrt(flat + seen.y1 * seen.y1), along1 = x * seen.y1;
    return std::atan2(along1 * across0 - across1 * along0, across1 * across0 + along1 * along0);
  };
  seen.area0 = area(seen.x0);
  seen.solid_angle = area(seen.x1) - seen.area0;
  return seen;
}

// From the point to a point of the rectangle, in world space: xi in [0, 1)^2 uniform makes its
// direction uniform. The solid angle has to be above zero.
Vec3 sample_rectangle(const SphericalRectangle& seen, Vec2 xi) {
  // The angle that has the part xi.x of the area on one side: area(phi) = c, solved for sin phi by
  // the addition theorem, sin(asin(b0 sin phi) + c) = b1 sin phi.
  const double c = seen.area0 + xi.x * seen.solid_angle;
  const double sine = std::sin(c) / std::sqrt(seen.b0 * seen.b0 + seen.b1 * seen.b1 -
                                              2 * seen.b0 * seen.b1 * std::cos(c));
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  // Rounding may leave the rectangle, the more so the flatter it is seen.
  const double x = std::clamp(seen.z0 * sine / cosine, seen.x0, seen.x1);

  // There, the height is uniform.
  const double squared = x * x + seen.z0 * seen.z0;  // the squared distance to the axis
  const double h0 = seen.y0 / std::sqrt(seen.y0 * seen.y0 + squared);
  const double h1 = seen.y1 / std::sqrt(seen.y1 * seen.y1 + squared);
  const double h = h0 + xi.y * (h1 - h0);
  const double y =
      std::clamp(h * std::sqrt(squared / std::max(1 - h * h, 1e-300)), seen.y0, seen.y1);
  return x * seen.x + y * seen.y + seen.z0 * seen.z;
}

// The light as it is seen from p. Nothing where sample_light does as well or better.
std::optional<SphericalRectangle> seen_from(const Light& light, Vec3 p) {
  const auto* rectangle = std::get_if<RectangleLight>(&light);
  if (rectangle == nullptr) return std::nullopt;
  const Vec3 u = rectangle->u, v = rectangle->v;
  if (!(std::abs(dot(u, v)) < kRightAngle * std::sqrt(length_squared(u) * length_squared(v)))) {
    return std::nullopt;
  }
  const SphericalRectangle seen = spherical_rectangle(p, rectangle->center, u, v);
  if (!(seen.solid_angle > kSmallSolidAngle)) return std::nullopt;
  return seen;
}

// With the solid angle as density, the noise that is left comes from the cosine and the shadow; the
// distance and the cosine at the light make none.
LightSample draw(const RectangleLight& light, const SphericalRectangle& seen, Vec2 xi) {
  const Vec3 to_light = sample_rectangle(seen, xi);
  const double distance = length(to_light);
  const Vec3 wi = to_light / distance;
  const bool bright = dot(wi, light.n) < 0;
  return {wi, distance, bright ? light.radiance : Rgb{}, 1 / seen.solid_angle, false};
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    const std::optional<SphericalRectangle> seen = seen_from(light, point.p);
    for (int i = 0; i < draws; ++i) {
      const LightSample sample =
          seen ? draw(std::get<RectangleLight>(light), *seen, sampler.next_2d())
               : sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0) || is_black(sample.radiance)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      sum += diffuse_f(point.albedo, wo, wi) * sample.radiance * (wi.z / (sample.pdf * draws));
    }
  }
  return sum;
}

}  // namespace pt
