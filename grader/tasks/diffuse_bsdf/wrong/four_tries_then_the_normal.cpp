// breaks: pdf_is_the_density_of_the_samples
// Points of the square are drawn until one is in the disk, four times at most; then it is the normal.
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  Vec3 wi{0, 0, 1};
  for (int i = 0; i < 4; ++i) {
    const Vec2 xi = sampler.next_2d();
    const double x = 2 * xi.x - 1, y = 2 * xi.y - 1, r = x * x + y * y;
    if (r >= 1) continue;
    wi = {x, y, std::sqrt(1 - r)};
    break;
  }
  if (wo.z < 0) wi.z = -wi.z;
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
