// right: points of the unit disk by rejection, lifted to the hemisphere.
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>
#include <functional>
namespace pt {

namespace {

bool same_side(Vec3 wo, Vec3 wi) { return wo.z * wi.z > 0; }

// A uniform point of the disk, found by throwing away those of the square that are outside.
Vec3 lifted(Sampler& sampler) {
  const std::function<bool(double)> is_inside = [](double squared) { return squared < 1; };
  for (;;) {
    const double x = 2 * sampler.next_1d() - 1;
    const double y = 2 * sampler.next_1d() - 1;
    const double squared = x * x + y * y;
    if (is_inside(squared)) return {x, y, std::sqrt(1 - squared)};
  }
}
}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? albedo / kPi : Rgb{}; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const Vec3 wi = lifted(sampler);
  return {wi, diffuse_f(albedo, wo, wi), diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) { return same_side(wo, wi) ? std::abs(wi.z) / kPi : 0; }

}  // namespace pt
