// right: uniform directions, each kept with the probability of its cosine.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace pt {

namespace {

Vec3 kept(Sampler& sampler) {
  for (;;) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    if (sampler.next_1d() < wi.z) return wi;
  }
}

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  return (wo.z > 0) == (wi.z > 0) ? albedo / kPi : Rgb{};
}

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const Vec3 wi = kept(sampler);
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return (wo.z > 0) == (wi.z > 0) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
