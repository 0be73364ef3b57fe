// Ordinary inputs: 20,000 pairs of directions and one sample for each, and means of these samples.
#include "pt/tasks/diffuse_bsdf.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <cmath>

using namespace pt;
using namespace pt::inputs;

constexpr int kInputs = 20000;

static bool is_near(Rgb a, Rgb b) {
  return std::abs(a.r - b.r) <= 1e-4 && std::abs(a.g - b.g) <= 1e-4 && std::abs(a.b - b.b) <= 1e-4;
}

static Vec3 any_above(Sampler& sampler) {
  const Vec3 v = any_direction(sampler);
  return v.z < 0 ? -v : v;
}

EXAMPLE("f is the albedo over pi, and zero across the surface") {
  Sampler sampler(1);
  int differ = 0;
  for (int i = 0; i < kInputs; ++i) {
    const Rgb albedo = any_color(sampler);
    const Vec3 wo = any_direction(sampler), wi = any_direction(sampler);
    const bool same_side = wo.z * wi.z > 0;
    const bool is_right = is_near(diffuse_f(albedo, wo, wi), same_side ? albedo / kPi : Rgb{}) &&
                          (same_side || diffuse_pdf(wo, wi) == 0);
    if (!is_right) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}

EXAMPLE("a sample is a unit vector on the side of wo, and knows its f and pdf") {
  Sampler sampler(1);
  int differ = 0;
  for (int i = 0; i < kInputs; ++i) {
    const Rgb albedo = any_color(sampler);
    const Vec3 wo = any_above(sampler);
    Sampler again = sampler;
    const BsdfSample sample = diffuse_sample(albedo, wo, sampler);
    const double pdf = diffuse_pdf(wo, sample.wi);
    const bool is_right = sample.wi.z > 0 && std::abs(length(sample.wi) - 1) <= 1e-4 &&
                          is_near(sample.f, diffuse_f(albedo, wo, sample.wi)) &&
                          std::abs(sample.pdf - pdf) <= 1e-4 &&
                          length(diffuse_sample(albedo, wo, again).wi - sample.wi) == 0;
    if (!is_right) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}

// Returns the mean of g(wi) / pdf over many samples: the integral of g, whatever density they have. For g = cos its noise is limited
// by the contract.
template <class Function>
static double integral(Sampler& sampler, const Function& g) {
  double sum = 0;
  for (int i = 0; i < kInputs; ++i) {
    const BsdfSample sample = diffuse_sample({0.5, 0.5, 0.5}, any_above(sampler), sampler);
    sum += g(sample.wi) / sample.pdf;
  }
  return sum / kInputs;
}

EXAMPLE("the samples have the density that they name") {
  Sampler sampler(1);
  const auto part = [](bool inside, Vec3 wi) { return inside ? wi.z : 0; };
  // Each is a part of the integral of the cosine, pi.
  NEAR(integral(sampler, [&](Vec3 wi) { return part(true, wi); }), kPi, 0.12);
  NEAR(integral(sampler, [&](Vec3 wi) { return part(wi.x > 0, wi); }), kPi / 2, 0.12);
  NEAR(integral(sampler, [&](Vec3 wi) { return part(wi.y > 0, wi); }), kPi / 2, 0.12);
  NEAR(integral(sampler, [&](Vec3 wi) { return part(wi.x > wi.y, wi); }), kPi / 2, 0.12);
  NEAR(integral(sampler, [&](Vec3 wi) { return part(wi.z * wi.z > 0.5, wi); }), kPi / 2, 0.12);
  NEAR(integral(sampler, [&](Vec3 wi) { return part(wi.z * wi.z > 0.9, wi); }), kPi / 10, 0.06);
}

EXAMPLE("the pdf sums to one") {
  Sampler sampler(1);
  double sum = 0;
  for (int i = 0; i < kInputs; ++i)
    sum += 4 * kPi * diffuse_pdf(any_above(sampler), any_direction(sampler));
  NEAR(sum / kInputs, 1, 0.06);
}

EXAMPLE("one sample does not depend on the sample before") {
  Sampler sampler(1);
  Vec3 sum{0, 0, 0};
  Vec3 before = diffuse_sample({0.5, 0.5, 0.5}, {0, 0, 1}, sampler).wi;
  for (int i = 0; i < kInputs; ++i) {
    const Vec3 wi = diffuse_sample({0.5, 0.5, 0.5}, {0, 0, 1}, sampler).wi;
    sum = sum + Vec3{wi.x * before.x, wi.y * before.y, 0};
    before = wi;
  }
  NEAR((1.0 / kInputs) * sum, {0, 0, 0}, 0.02);
}
