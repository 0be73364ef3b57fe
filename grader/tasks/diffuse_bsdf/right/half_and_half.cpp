// right: half of the samples uniform, half by the cosine, with the density of the mixture.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>
namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }
}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const double chooses = sampler.next_1d();
  const Vec2 xi = sampler.next_2d();
  const Vec3 wi = chooses < 0.5 ? uniform_hemisphere(xi) : cosine_hemisphere(xi);
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  return same_side(wo, wi) ? 0.5 / (2 * kPi) + 0.5 * std::abs(wi.z) / kPi : 0;
}

}  // namespace pt
