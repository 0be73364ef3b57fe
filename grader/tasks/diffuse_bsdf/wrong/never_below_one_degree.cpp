// breaks: pdf_is_the_density_of_the_samples
// Samples lower than 1.3 degrees above the surface are lifted to that height.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <cmath>

namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  Vec3 wi = cosine_hemisphere(sampler.next_2d());
  wi.z = std::max(0.0227, wi.z);
  wi = normalize(wi);
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
