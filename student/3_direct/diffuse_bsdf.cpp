#include "pt/tasks/diffuse_bsdf.h"

#include "pt/sampling/directions.h"
#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: return the BSDF of a diffuse surface, and choose directions of which you know the density.
Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi) {
  todo("diffuse_bsdf");
  return {};
}

BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler) {
  todo("diffuse_bsdf");
  return {{0, 0, 1}, {}, 1};
}

double diffuse_pdf(Vec3 wo, Vec3 wi) {
  todo("diffuse_bsdf");
  return 0;
}

}  // namespace pt
