#include "measure/calls/estimates.h"
#include "measure/calls/exact.h"
#include "pt/tasks/diffuse_bsdf.h"

namespace measure::calls {

namespace {

using pt::Rgb;
using pt::Vec3;

constexpr std::uint64_t kSeed = 31;

struct Patch {
  Rgb albedo;
  Vec3 wo;
  double truth = 0;
};

// The sky over a patch. Weighted by the cosine, its mean is 1, the mean of wi.x 0, that of wi.z^2 1/2.
double sky(Vec3 wi) { return 0.5 + 0.4 * wi.x + wi.z * wi.z; }

std::vector<Patch> patches() {
  pt::Sampler sampler(kSeed);
  std::vector<Patch> all;
  while (all.size() < kPlaces) {
    Vec3 wo = any_direction(sampler);
    wo.z = std::abs(wo.z) + 1e-3;
    const double r = between(0.1, 1, sampler), g = between(0.1, 1, sampler);
    const Rgb albedo{r, g, between(0.1, 1, sampler)};
    all.push_back({albedo, normalize(wo), luminance(albedo)});
  }
  return all;
}

// Notes the errors of f, and of the density that a sample says it has.
void look_at_bsdf(const Patch& patch, pt::Sampler& sampler, Found& found) {
  const pt::BsdfSample sample = pt::diffuse_sample(patch.albedo, patch.wo, sampler);
  for (const Rgb& f : {pt::diffuse_f(patch.albedo, patch.wo, sample.wi), sample.f}) {
    for (int channel = 0; channel < 3; ++channel) {
      keep_largest(found.errors[0], f[channel] * pt::kPi / patch.albedo[channel] - 1);
    }
  }
  keep_largest(found.errors[0], sample.pdf / pt::diffuse_pdf(patch.wo, sample.wi) - 1);
}

}  // namespace

Subject measure_diffuse_bsdf(int) {
  const std::vector<Patch> all = patches();
  Subject subject = estimator_subject(all, [](const Patch& patch, pt::Sampler& sampler) {
    const pt::BsdfSample sample = pt::diffuse_sample(patch.albedo, patch.wo, sampler);
    return Estimate{luminance(sample.f) * sample.wi.z / sample.pdf * sky(sample.wi), 0};
  });
  subject.find = [all, estimates = subject.find](std::uint64_t seed) {
    Found found = estimates(seed);
    pt::Sampler sampler(seed + 1);
    for (const Patch& patch : all) look_at_bsdf(patch, sampler, found);
    return found;
  };
  return subject;
}

}  // namespace measure::calls
