// right: the height of a direction is the largest of three random numbers, with density
// 3 z^2 / (2 pi): steeper than the cosine
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return (wo.z > 0 && wi.z > 0) || (wo.z < 0 && wi.z < 0); }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

// f cos / pdf is 2 albedo / (3 z), whose standard deviation is albedo / sqrt(3).
BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  std::array<double, 3> heights;
  std::ranges::generate(heights, [&] { return sampler.next_1d(); });
  const double z = std::ranges::max(heights), phi = 2 * kPi * sampler.next_1d();
  const double r = std::sqrt((1 - z) * (1 + z));
  const Vec3 wi{r * std::cos(phi), r * std::sin(phi), z};
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? 1.5 * wi.z * wi.z / kPi : 0; }

}  // namespace pt
