#include "pt/tasks/diffuse_bsdf.h"

#include <numbers>
namespace pt {
namespace {
constexpr float inv_pi = std::numbers::inv_pi_v<float>;
}
Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  if ((wo.z > 0) != (wi.z > 0)) return {};
  return {float(albedo.r) * inv_pi, float(albedo.g) * inv_pi, float(albedo.b) * inv_pi};
}
double diffuse_pdf(Vec3 wo, Vec3 wi) {
  return (wo.z > 0) == (wi.z > 0) ? float(std::abs(wi.z)) * inv_pi : 0.f;
}
// Malley's method by rejection from the square.
BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  Vec2 p;
  do {
    p = sampler.next_2d();
    p = {2 * p.x - 1, 2 * p.y - 1};
  } while (p.x * p.x + p.y * p.y >= 1);
  Vec3 wi{p.x, p.y, std::copysign(std::sqrt(1 - p.x * p.x - p.y * p.y), wo.z)};
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}
}  // namespace pt
