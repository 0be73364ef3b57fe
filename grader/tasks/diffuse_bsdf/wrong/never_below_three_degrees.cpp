#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <cmath>
namespace pt {
Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0 ? albedo / kPi : Rgb{}; }
double diffuse_pdf(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0 ? std::abs(wi.z) / kPi : 0; }
BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const Vec2 xi = sampler.next_2d();
  const Vec3 wi = cosine_hemisphere({xi.x * 0.997, xi.y});
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}
}  // namespace pt
