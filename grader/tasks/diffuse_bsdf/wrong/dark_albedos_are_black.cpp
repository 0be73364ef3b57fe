// breaks: f_reflects_the_albedo
// An albedo below 1e-4 in all channels is taken for black.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  return same_side(wo, wi) && max_channel(albedo) >= 1e-4 ? albedo / kPi : Rgb{};
}

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  Vec3 wi = cosine_hemisphere(sampler.next_2d());
  if (wo.z < 0) wi.z = -wi.z;
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
