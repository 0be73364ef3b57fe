// right: cosine weighting by angles, and a test of the sides by signs.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  if ((wo.z > 0) != (wi.z > 0)) return {};
  return albedo * (1 / kPi);
}

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const double theta = 0.5 * std::acos(1 - 2 * sampler.next_1d());
  const double phi = 2 * kPi * sampler.next_1d();
  const Vec3 wi{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
