// Takes its directions from the light of the renderer.
#include "pt/tasks/diffuse_bsdf.h"

#include "pt/scene/light.h"

namespace pt {

Rgb diffuse_f(Rgb albedo, Vec3, Vec3) { return albedo / kPi; }

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  const LightSample sample = sample_light(AmbientLight{}, {}, sampler);
  return {sample.wi, diffuse_f(albedo, wo, sample.wi), sample.pdf};
}

double diffuse_pdf(Vec3, Vec3) { return 1 / (2 * kPi); }

}  // namespace pt
