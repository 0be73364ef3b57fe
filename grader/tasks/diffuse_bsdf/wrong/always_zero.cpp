#include "pt/tasks/diffuse_bsdf.h"

namespace pt {

Rgb diffuse_f(Rgb, Vec3, Vec3) { return {}; }

BsdfSample diffuse_sample(Rgb, Vec3, Sampler&) { return {}; }

double diffuse_pdf(Vec3, Vec3) { return 0; }

}  // namespace pt
