#include "grader/check/generators/generators.h"
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/property.h"
#include "grader/tasks/diffuse_bsdf/inputs.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace diffuse_bsdf_inputs;

double off(double got, double right) {
  return std::abs(got - right) / (kColorPrecision * std::abs(right));
}

SEARCH(diffuse_bsdf, samples) {
  return {.title = "a sample: its length, its f, its pdf, and that it is on the side of wo",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const double z = *magnitude(1e-9, 1), phi = *real(-pt::kPi, pt::kPi);
            const double albedo = *real(1e-6, 1);
            const Vec3 wo = at(z, phi);
            const std::uint64_t seed = *sampler_seed();
            show_input([&] { return "wo " + show(wo) + ", seed " + std::to_string(seed); });
            pt::Sampler sampler(seed);
            const pt::BsdfSample s = pt::diffuse_sample(pt::gray(albedo), wo, sampler);
            if (!(s.wi.z > 0) || !(s.pdf > 0)) return kBroken;
            return std::max({off(length(s.wi), 1), off(s.f.r, albedo / pt::kPi),
                             off(s.pdf, pt::diffuse_pdf(wo, s.wi)),
                             off(pt::diffuse_f(pt::gray(albedo), wo, s.wi).r, albedo / pt::kPi)});
          }};
}

}  // namespace
}  // namespace grader::check
