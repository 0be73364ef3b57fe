// method: the cone of directions to a sphere as textbooks have it: 1 - cos is a difference
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>
#include <variant>

#ifndef REAL
#define REAL double
#endif

namespace pt {

namespace {

// The density of a direction of the cone, and the cosine of its angle to the axis.
struct Drawn {
  REAL pdf, cosine;
};

Drawn draw_from_cone(REAL radius, REAL distance, REAL xi) {
  const REAL sine = radius / distance, edge = std::sqrt(std::max(REAL{0}, 1 - sine * sine));
  return {1 / (2 * REAL{kPi} * (1 - edge)), 1 - xi * (1 - edge)};
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const auto* const ball = std::get_if<SphereLight>(&light);
    if (ball == nullptr) continue;
    const Vec3 to_center = ball->center - point.p;
    const Frame frame = frame_from_normal(normalize(to_center));
    for (int i = 0; i < samples; ++i) {
      const Vec2 xi = sampler.next_2d();
      const Drawn drawn =
          draw_from_cone(static_cast<REAL>(ball->radius), static_cast<REAL>(length(to_center)),
                         static_cast<REAL>(xi.x));
      const double side = std::sqrt(std::max(0.0, 1.0 - drawn.cosine * drawn.cosine));
      const double angle = 2 * kPi * xi.y;
      const Vec3 towards{side * std::cos(angle), side * std::sin(angle), drawn.cosine};
      const Vec3 wi = point.frame.to_local(frame.to_world(towards));
      if (!(wi.z > 0)) continue;
      sum += diffuse_f(point.albedo, wo, wi) * ball->radiance * (wi.z / drawn.pdf / samples);
    }
  }
  return sum;
}

}  // namespace pt
