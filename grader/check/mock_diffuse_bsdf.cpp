#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

// Beside a trace_path that is judged alone: a surface that is seen straight from above chooses its
// directions uniformly, seen from elsewhere by the cosine. Both are right, and f cos / pdf is the
// albedo for one of them only. wo and wi are taken to be on one side: that is all trace_path needs.

namespace pt {

namespace {

bool seen_from_above(Vec3 wo) { return wo.z > 1 - 1e-9; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3, Vec3) { return albedo / kPi; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const Vec2 xi = sampler.next_2d();
  Vec3 wi = seen_from_above(wo) ? uniform_hemisphere(xi) : cosine_hemisphere(xi);
  if (wo.z < 0) wi.z = -wi.z;
  return {wi, albedo / kPi, diffuse_pdf(wo, wi)};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  return seen_from_above(wo) ? 1 / (2 * kPi) : std::abs(wi.z) / kPi;
}

}  // namespace pt
