// right: of a rectangle, every direction in which it is seen is equally likely.
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/spherical_rectangle.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <cmath>
#include <optional>

namespace pt {

namespace {

// A light that looks smaller has no noise that would be worth the digits.
constexpr double kSmallSolidAngle = 1e-6;
constexpr double kRightAngle = 1e-9;  // cosine

// The light as it is seen from p (Ureña, Fajardo and King 2013, An Area-Preserving Parametrization
// for Spherical Rectangles). Nothing where sample_light does as well or better.
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
