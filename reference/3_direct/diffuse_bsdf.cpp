#include "pt/tasks/diffuse_bsdf.h"

#include "pt/sampling/directions.h"

#include <cmath>

namespace pt {

namespace {

// The product of two tiny cosines would be 0.
bool same_side(Vec3 wo, Vec3 wi) { return (wo.z > 0 && wi.z > 0) || (wo.z < 0 && wi.z < 0); }

}  // namespace

// The integral of the cosine over the hemisphere is pi: divided by it, f reflects just the albedo.
Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

// Light counts in proportion to the cosine. If directions are chosen in proportion to the cosine,
// too, f cos / pdf is the same for all of them.
BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  Vec3 wi = cosine_hemisphere(sampler.next_2d());
  if (wo.z < 0) wi.z = -wi.z;
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
