#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

namespace pt {

// A direction wi from which light may come, the value f of the BSDF for it, and the density pdf
// (per steradian) with which it was chosen.
struct BsdfSample {
  Vec3 wi;
  Rgb f;
  double pdf = 0;
};

// Reflection by a diffuse surface: the same radiance in all directions (Lambert).
//
// In:  wo and wi are unit vectors in the local frame, with z along the normal. Both point away from
//      the surface. The albedo, in [0, 1], is the part of the light that is not absorbed. For
//      diffuse_sample, wo.z > 0.
// Out: diffuse_f is the BSDF, per steradian, without any cosine: the same for all directions, but
//      zero if wo and wi are on different sides. diffuse_sample chooses wi on wo's side, with any
//      continuous density that is not zero there (uniform, cosine-weighted), and returns f and that
//      density. diffuse_pdf is the density with which diffuse_sample chooses wi. It is zero on the
//      other side. The sampler is the only source of random numbers. Below, cos is the cosine of
//      the angle between wi and the normal: wi.z.
//
// Promises:
//   - f reflects the albedo: the integral of f cos over all wi is the albedo, in each channel.
//   - f is the same for all directions: as long as wo and wi are on the same side.
//   - f is zero across the surface: if wo and wi are on different sides. With both below, f is the
//     same as with both above.
//   - samples the side of wo: wi is a unit vector with wi.z > 0, and all directions around the
//     normal occur.
//   - a sample knows its own f and pdf: they equal the results of diffuse_f and diffuse_pdf for it.
//   - pdf is the density of the samples: a histogram of many samples agrees with it.
//   - pdf sums to one: its integral over the side of wo is 1. It is zero on the other side.
//   - samples estimate the albedo: the mean of f cos / pdf is the albedo, with no more noise than
//     the contract allows.
//   - draws from the sampler alone: consecutive samples are independent, and a sampler in the same
//     state gives the same sample again.
//
// Noise: f cos / pdf of a sample has a standard deviation of at most the albedo. It is 0.58
// times the albedo for uniform directions, and zero for cosine-weighted ones.
//
// Precision: f, and the albedo that it reflects, are right to 1e-5 of their size. The pdf (per
// steradian) and the length of wi are right to 1e-5. Single precision is enough, and so is pi to
// six digits. If a cosine is below 1e-100, f may be zero: in double precision, the product of two
// such numbers is zero.
//
// May call: no other task.
// Threads: the functions are called from several threads at once, so nothing static may change.
Rgb diffuse_f(Rgb albedo, Vec3 wo, Vec3 wi);
BsdfSample diffuse_sample(Rgb albedo, Vec3 wo, Sampler& sampler);
double diffuse_pdf(Vec3 wo, Vec3 wi);

}  // namespace pt
