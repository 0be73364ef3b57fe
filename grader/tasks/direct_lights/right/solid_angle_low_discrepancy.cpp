// right: rectangles by solid angle, by points that spread over it more evenly than random ones.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pt {

namespace {

constexpr double kSmallSolidAngle = 1e-6;
constexpr double kRightAngle = 1e-9;  // cosine

// Point i of a sequence that fills the square [0, 1)^2 evenly, however many points of it are taken
// (Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences), moved by `start`. With a start that is
// uniform in the square, so is each point (Cranley and Patterson 1976): a mean over the points has no bias.
Vec2 low_discrepancy_point(Vec2 start, int i) {
  // 1 / g and 1 / g^2, where g^3 = g + 1: the golden ratio of two dimensions.
  const double x = start.x + 0.7548776662466927 * i;
  const double y = start.y + 0.5698402909980532 * i;
  return {x - std::floor(x), y - std::floor(y)};
}

// A rectangle as it is seen from a point, whose directions can be drawn uniformly; solid_angle.cpp says how.
struct SphericalRectangle {
  Vec3 x, y, z;  // unit, world space
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0, z0 = 0;
  double b0 = 0, b1 = 0;
  double area0 = 0;        // area(phi) where x = x0; negative if x0 < 0
  double solid_angle = 0;  // zero where the point is in the plane
};

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
    const Vec2 start = seen ? sampler.next_2d() : Vec2{};
    for (int i = 0; i < draws; ++i) {
      const LightSample sample =
          seen ? draw(std::get<RectangleLight>(light), *seen, low_discrepancy_point(start, i))
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
