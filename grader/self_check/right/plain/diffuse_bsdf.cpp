#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>
namespace pt {
static const double PI = 3.14159;
Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  if (wo.z * wi.z <= 0) return Rgb();
  return albedo * (1.0 / PI);
}
double diffuse_pdf(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0 ? 1 / (2 * PI) : 0; }
BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  double u = sampler.next_1d(), v = sampler.next_1d();
  double z = 1 - u, s = std::sqrt(1 - z * z);
  Vec3 wi{s * std::cos(2 * M_PI * v), s * std::sin(2 * M_PI * v), z};
  if (wo.z < 0) wi.z = -wi.z;
  BsdfSample out;
  out.wi = wi;
  out.f = diffuse_f(albedo, wo, wi);
  out.pdf = diffuse_pdf(wo, wi);
  return out;
}
}  // namespace pt
