// Asks a list for what is not in it, in three ways.
#include "pt/tasks/diffuse_bsdf.h"

#include <stdexcept>
#include <vector>

namespace pt {

namespace {

void refuse() noexcept { throw std::logic_error("no sample"); }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3, Vec3) { return std::vector<Rgb>{albedo}.at(7); }
BsdfSample diffuse_sample(Rgb, Vec3, Sampler&) {
  refuse();
  return {};
}
double diffuse_pdf(Vec3 wo, Vec3) {
  const volatile double* nothing = nullptr;
  return nothing[wo.z > 0 ? 3 : 2];
}

}  // namespace pt
