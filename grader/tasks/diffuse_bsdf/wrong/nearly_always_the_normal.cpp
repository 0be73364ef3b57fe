// breaks: samples_estimate_the_albedo
// A right mixture that draws 99 of 100 samples around the normal: the others count too much.
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
  const Vec3 wi = chooses < 0.99 ? uniform_cone(xi, 0.1) : uniform_hemisphere(xi);
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  if (!same_side(wo, wi)) return 0;
  return (0.01 + (std::abs(wi.z) >= 0.9 ? 9.9 : 0)) / (2 * kPi);
}

}  // namespace pt
