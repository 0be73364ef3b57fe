#include "pt/sampling/directions.h"
#include "pt/scene/recorder.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

// The mock version of the BSDF for a trace_path that is judged alone. A surface that is seen from
// straight above draws uniform directions; seen from elsewhere, it draws cosine-weighted ones. Both
// are right, but f cos / pdf is the albedo only for the second. wo and wi are assumed to be on one
// side, which is all that trace_path needs.

namespace pt {

namespace {

bool seen_from_above(Vec3 wo) { return wo.z > 1 - 1e-9; }

}  // namespace

Rgb diffuse_f(Rgb albedo, Vec3, Vec3) { return albedo / kPi; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  // The record of a path has its directions (grader/explain/record.h).
  return keep_call(
      "diffuse_sample",
      [&] {
        const Vec2 xi = sampler.next_2d();
        Vec3 wi = seen_from_above(wo) ? uniform_hemisphere(xi) : cosine_hemisphere(xi);
        if (wo.z < 0) wi.z = -wi.z;
        return BsdfSample{wi, albedo / kPi, diffuse_pdf(wo, wi)};
      },
      albedo, wo, sampler);
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  return seen_from_above(wo) ? 1 / (2 * kPi) : std::abs(wi.z) / kPi;
}

}  // namespace pt
