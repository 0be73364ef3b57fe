// right: everything in single precision, with pi to six digits.
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace pt {

namespace {

constexpr float kSixDigits = 3.14159f;

bool same_side(Vec3 wo, Vec3 wi) { return (wo.z > 0) == (wi.z > 0); }

float times(double albedo) { return static_cast<float>(albedo) / kSixDigits; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  if (!same_side(wo, wi)) return {};
  return {times(albedo.r), times(albedo.g), times(albedo.b)};
}

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const float height = static_cast<float>(1 - sampler.next_1d());  // never 0
  const float turn = 2 * kSixDigits * static_cast<float>(sampler.next_1d());
  const float r = std::sqrt(1 - height);
  const Vec3 wi{r * std::cos(turn), r * std::sin(turn), std::sqrt(height)};
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  return same_side(wo, wi) ? std::abs(static_cast<float>(wi.z)) / kSixDigits : 0.0f;
}

}  // namespace pt
