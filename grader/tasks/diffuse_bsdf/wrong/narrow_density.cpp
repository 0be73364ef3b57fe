// breaks: samples_estimate_the_albedo
// A density that is right and hardly ever chooses flat directions: f cos / pdf has an infinite
// variance.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>
namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }
}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const Vec2 xi = sampler.next_2d();
  const double z = std::pow(1 - xi.x, 1.0 / 8);
  const double r = std::sqrt(1 - z * z);
  const Vec3 wi{r * std::cos(2 * kPi * xi.y), r * std::sin(2 * kPi * xi.y), z};
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  return same_side(wo, wi) ? 8 * std::pow(std::abs(wi.z), 7) / (2 * kPi) : 0;
}

}  // namespace pt
