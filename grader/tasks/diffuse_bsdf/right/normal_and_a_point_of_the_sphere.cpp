// right: the normal plus a point of the unit sphere, by rejection from the ball, gives cosine-weighted
// directions.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace pt {

namespace {

Vec3 on_the_sphere(Sampler& sampler) {
  for (;;) {
    const double x = 2 * sampler.next_1d() - 1;
    const double y = 2 * sampler.next_1d() - 1;
    const double z = 2 * sampler.next_1d() - 1;
    const Vec3 inside{x, y, z};
    const double squared = length_squared(inside);
    if (squared > 1e-30 && squared <= 1) return inside / std::sqrt(squared);
  }
}

Vec3 around_the_normal(Sampler& sampler) {
  for (;;) {
    const Vec3 sum = Vec3{0, 0, 1} + on_the_sphere(sampler);
    if (sum.z > 1e-12) return normalize(sum);
  }
}

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  return (wo.z > 0) == (wi.z > 0) ? albedo / kPi : Rgb{};
}

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const Vec3 wi = around_the_normal(sampler);
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return (wo.z > 0) == (wi.z > 0) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
