// right: multiple importance sampling of lights with a closed form, weighted by the power heuristic
// with the exponent 2 (Veach and Guibas 1995).
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <cmath>

namespace pt {

namespace {

// The light that a direction finds, as sample_light would have drawn it. No pdf, no light.
struct Found {
  double distance = 0;
  Rgb radiance;
  double pdf = 0;
};

Found find(const RectangleLight& light, Vec3 p, Vec3 wi) {
  const double cos_light = -dot(wi, light.n);
  if (!(cos_light > 0)) return {};
  const double distance = dot(p - light.center, light.n) / cos_light;
  const Vec3 q = p + distance * wi - light.center;
  // q = a u + b v; the sides need not be at right angles.
  const Vec3 sides = cross(light.u, light.v);
  const double a = dot(cross(q, light.v), sides) / length_squared(sides);
  const double b = dot(cross(light.u, q), sides) / length_squared(sides);
  const bool inside = std::abs(a) <= 0.5 && std::abs(b) <= 0.5;
  if (!(distance > 0) || !inside) return {};
  const double area = length(cross(light.u, light.v));
  return {distance, light.radiance, distance * distance / (cos_light * area)};
}

Found find(const SphereLight& light, Vec3 p, Vec3 wi) {
  const Vec3 to_center = light.center - p;
  const double along = dot(to_center, wi);
  const double half_chord_squared =
      light.radius * light.radius - length_squared(to_center - along * wi);
  if (!(along > 0 && half_chord_squared > 0)) return {};
  const double sine_squared = light.radius * light.radius / length_squared(to_center);
  const double one_minus_cos = sine_squared / (1 + std::sqrt(1 - sine_squared));
  return {along - std::sqrt(half_chord_squared), light.radiance, 1 / (2 * kPi * one_minus_cos)};
}

Found find(const AmbientLight& light, Vec3, Vec3 wi) {
  if (!(wi.y > 0)) return {};
  return {kInfinity, light.radiance, 1 / (2 * kPi)};
}

// Lights that only their own samples find.
template <class Other>
Found find(const Other&, Vec3, Vec3) {
  return {};
}

bool is_found_both_ways(const Light& light) {
  return std::holds_alternative<RectangleLight>(light) ||
         std::holds_alternative<SphereLight>(light) || std::holds_alternative<AmbientLight>(light);
}

// The weight of a draw over its density.
double weight_over_pdf(double pdf, double other) { return pdf / (pdf * pdf + other * other); }

Rgb draw(const Scene& scene, const SurfacePoint& point, const Light& light, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  const bool both_ways = is_found_both_ways(light);
  Rgb sum;

  const LightSample sample = sample_light(light, point.p, sampler);
  const Vec3 local = point.frame.to_local(sample.wi);
  if (local.z > 0 && !is_black(sample.radiance) &&
      !scene.occluded(shadow_ray(point, sample.wi, sample.distance))) {
    const double other_pdf = both_ways ? diffuse_pdf(wo, local) : 0;
    sum += diffuse_f(point.albedo, wo, local) * sample.radiance *
           (local.z * weight_over_pdf(sample.pdf, other_pdf));
  }
  if (!both_ways) return sum;

  const BsdfSample turn = diffuse_sample(point.albedo, wo, sampler);
  const Vec3 wi = point.frame.to_world(turn.wi);
  const Found found = std::visit([&](const auto& kind) { return find(kind, point.p, wi); }, light);
  if (found.pdf > 0 && !scene.occluded(shadow_ray(point, wi, found.distance))) {
    sum += turn.f * found.radiance * (turn.wi.z * weight_over_pdf(turn.pdf, found.pdf));
  }
  return sum;
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    for (int i = 0; i < draws; ++i) sum += draw(scene, point, light, sampler) / draws;
  }
  return sum;
}

}  // namespace pt
