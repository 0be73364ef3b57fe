// breaks: pdf_is_the_density_of_the_samples
// The angle around the normal is a whole number of degrees.
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
  Vec3 wi = cosine_hemisphere({xi.x, static_cast<int>(360 * xi.y) / 360.0});
  if (wo.z < 0) wi.z = -wi.z;
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
