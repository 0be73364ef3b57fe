#include "grader/check/generators/generators.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/generators/special.h"
#include "grader/check/language/in_a_row.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/language/repetition.h"
#include "grader/tasks/diffuse_bsdf/density.h"
#include "grader/tasks/diffuse_bsdf/inputs.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace diffuse_bsdf_inputs;

// The error that the contract allows for a value of this size.
double tolerance(Rgb size) { return kColorPrecision * max_channel(size); }

PROMISE(diffuse_bsdf, f_reflects_the_albedo) {
  for_all(
      [] {
        const Rgb albedo = draw("albedo", any_albedo());
        const Vec3 wo = draw("wo", above());
        Rgb reflected;
        const std::vector<Vec3> directions = grid(10, 12);
        for (const Vec3 wi : directions) reflected += pt::diffuse_f(albedo, wo, wi) * wi.z;
        expect_near("f cos(wi), summed over the hemisphere",
                    reflected * (2 * pt::kPi / static_cast<double>(directions.size())), albedo,
                    tolerance(albedo));
      },
      20);
  // The same, of two surfaces that have some channels in common.
  for_all(
      [] {
        const Rgb albedo = draw("albedo", color(0.1, 1));
        Rgb other = draw("albedo of the second surface", color(0.1, 1));
        const int same = *whole(0, 2);
        other[same] = albedo[same];
        for (const Rgb each : {albedo, other, albedo}) {
          expect_near("f along the normal", pt::diffuse_f(each, {0, 0, 1}, {0, 0, 1}),
                      each / pt::kPi, tolerance(each));
        }
      },
      12);
  // The same, of surfaces whose channels are exchanged, or have the same sum.
  for_all(
      [] {
        const Rgb albedo = draw("albedo", color(0.05, 0.5));
        Rgb other = albedo;
        exchange_or_add_in(other);
        for (const Rgb each : {albedo, other, albedo}) {
          expect_near("f along the normal, after an albedo with other channels",
                      pt::diffuse_f(each, {0, 0, 1}, {0, 0, 1}), each / pt::kPi, tolerance(each));
        }
      },
      40);
}

// Any constant is the same for all directions. So f has to be a BSDF of the albedo, at least to a
// factor of ten; the promise f_reflects_the_albedo judges its size.
void expect_some_reflection(Rgb albedo, Rgb f) {
  const double part = max_channel(f) * pt::kPi;
  expect(is_black(albedo) || (part > max_channel(albedo) / 10 && part < max_channel(albedo) * 10),
         "an f of a tenth to ten times albedo / pi", "f is " + show(f));
}

void expect_same_f(const rc::Gen<Vec3>& directions) {
  const Rgb albedo = draw("albedo", any_albedo());
  const Vec3 wo = draw("wo", directions), wi = draw("wi", directions);
  const Rgb along_the_normal = pt::diffuse_f(albedo, {0, 0, 1}, {0, 0, 1});
  expect_some_reflection(albedo, along_the_normal);
  expect_near("f, and f along the normal", pt::diffuse_f(albedo, wo, wi), along_the_normal,
              tolerance(albedo));
}

PROMISE(diffuse_bsdf, f_is_the_same_for_all_directions) {
  for_all([] { expect_same_f(above()); });
  for_all([] { expect_same_f(grazing()); }, 10);
}

void expect_zero_across(const rc::Gen<Vec3>& directions) {
  const Rgb albedo = draw("albedo", color(0.25, 1));
  const Vec3 wo = draw("wo", directions), wi = draw("wi", directions);
  expect_near("f to below", pt::diffuse_f(albedo, wo, mirrored(wi)), {}, 0);
  expect_near("f from below", pt::diffuse_f(albedo, mirrored(wo), wi), {}, 0);
  const Rgb above_it = pt::diffuse_f(albedo, wo, wi);
  expect_some_reflection(albedo, above_it);
  expect_near("f with both below, and f with both above",
              pt::diffuse_f(albedo, mirrored(wo), mirrored(wi)), above_it, tolerance(albedo));
}

PROMISE(diffuse_bsdf, f_is_zero_across_the_surface) {
  for_all([] { expect_zero_across(above()); });
  for_all([] { expect_zero_across(grazing()); }, 10);
}

void expect_samples_all_around(const rc::Gen<Rgb>& albedos) {
  const Rgb albedo = draw("albedo", albedos);
  const Vec3 wo = draw("wo", above());
  const auto samples = repeat<pt::diffuse_sample>(2000, draw("seed", sampler_seed()), albedo, wo);
  const std::string wanted = "2000 samples in all directions, steep and flat" +
                             std::string(is_black(albedo) ? ", of a black surface too" : "");
  const Vec3 first = samples.at(0).wi;
  expect(std::ranges::any_of(samples, [&](const auto& s) { return s.wi != first; }), wanted,
         "all of them along " + show(first));
  std::vector<int> found(16);
  for (const pt::BsdfSample& sample : samples) {
    expect_near("the length of wi", length(sample.wi), 1, kColorPrecision);
    expect(sample.wi.z > 0, "wi above the surface, like wo", show(sample.wi));
    const int sector = static_cast<int>(
        4 * (1 + std::nextafter(std::atan2(sample.wi.y, sample.wi.x) / pt::kPi, 0.0)));
    ++found[2 * sector + (sample.wi.z < 0.5)];
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const int from = 45 * static_cast<int>(i / 2) - 180;
    expect(found[i] > 0, wanted,
           fmt::format("none {} than 60 degrees from the normal, {} to {} degrees around it",
                       i % 2 == 0 ? "less" : "more", from, from + 45));
  }
}

// Returns whether one of the next numbers of the sampler is 0.
bool draws_zero(pt::Sampler sampler, int numbers) {
  for (int i = 0; i < numbers; ++i) {
    if (sampler.next_1d() == 0) return true;
  }
  return false;
}

PROMISE(diffuse_bsdf, samples_the_side_of_wo) {
  for_all([] { expect_samples_all_around(any_albedo()); }, 9);
  for_all([] { expect_samples_all_around(rc::gen::just(Rgb{})); }, 1);
  // Only the number 0 may give a direction along the surface, as uniform_hemisphere does.
  for_all([] {
    const Rgb albedo = draw("albedo", any_albedo());
    const Vec3 wo = draw("wo", above());
    pt::Sampler sampler = sampler_of_a_rare_number(4);
    const bool zero = draws_zero(sampler, 4);
    const Vec3 wi = pt::diffuse_sample(albedo, wo, sampler).wi;
    expect_near("the length of wi", length(wi), 1, kColorPrecision);
    expect(wi.z > 0 || (zero && wi.z == 0), "wi above the surface, like wo", show(wi));
  });
}

PROMISE(diffuse_bsdf, a_sample_knows_its_own_f_and_pdf) {
  for_all([] {
    const Rgb albedo = draw("albedo", any_albedo());
    const Vec3 wo = draw("wo", above());
    pt::Sampler sampler(draw("seed", sampler_seed()));
    const pt::BsdfSample sample = pt::diffuse_sample(albedo, wo, sampler);
    expect_near("the sample's f, and diffuse_f for its wi", sample.f,
                pt::diffuse_f(albedo, wo, sample.wi), tolerance(albedo));
    expect_near("the sample's pdf, and diffuse_pdf for its wi", sample.pdf,
                pt::diffuse_pdf(wo, sample.wi), kColorPrecision);
    expect(sample.pdf > 0, "a pdf above 0 for a direction that was chosen", show(sample.pdf));
  });
}

// The pdf of a direction is the same after a call with exchanged numbers.
void expect_same_pdf_after_another() {
  const Vec3 wo = draw("wo", above()), wi = draw("wi", above());
  const double alone = pt::diffuse_pdf(wo, wi);
  pt::diffuse_pdf({0, 0, 1}, {0, 0, 1});
  Vec3 other_wo = wo, other_wi = wi;
  exchange_in({&other_wo, &other_wi});
  pt::diffuse_pdf(other_wo, other_wi);
  expect_near(fmt::format("the pdf, after that of wo {} and wi {}", show(other_wo), show(other_wi)),
              pt::diffuse_pdf(wo, wi), alone, kColorPrecision);
}

PROMISE(diffuse_bsdf, pdf_is_the_density_of_the_samples) {
  std::vector<std::array<double, 3>> all;
  for_all(expect_same_pdf_after_another, 40);
  for (int kind = 0; kind < kAlbedoKinds; ++kind) {
    for_all(
        [&, kind] {
          const Rgb albedo = draw("albedo", albedo_of_kind(kind));
          const Vec3 wo = draw("wo", above());
          std::vector<DirectionCell> cells = expected_by_pdf(wo);
          const auto samples =
              repeat<pt::diffuse_sample>(kSamples, draw("seed", sampler_seed()), albedo, wo);
          count_samples(cells, samples);
          expect_spread(cells, by_the_pdf(cells));
          for (const auto& [wi, f, pdf] : samples) all.push_back({wi.x, wi.y, wi.z});
          if (kind < kFirstBright) return;
          expect_different_samples(samples);
          expect_independent_angles({samples.begin(), samples.begin() + 1500});
        },
        1);
  }
  for_all(
      [] {
        const Rgb albedo = draw("albedo", any_albedo());
        const Vec3 wo = draw("wo", above());
        expect_samples_close_to_the_horizon(albedo, wo, draw("seed", sampler_seed()));
      },
      1);
  // A continuous density never gives a direction three times, not even one that stands for failed tries.
  once([&] {
    const std::size_t most = repetition(all).most;
    expect(most <= 2, fmt::format("{} samples of a continuous density", all.size()),
           fmt::format("exactly the same direction {} times", most));
  });
}

PROMISE(diffuse_bsdf, pdf_sums_to_one) {
  for_all(
      [] {
        const Vec3 wo = draw("wo", above());
        double sum = 0;
        const std::vector<Vec3> directions = grid(16, 8);
        for (const Vec3 wi : directions) {
          sum += pt::diffuse_pdf(wo, wi) * 2 * pt::kPi / static_cast<double>(directions.size());
        }
        expect_near("the pdf, summed over the hemisphere", sum, 1, 5e-3);
        const Vec3 below = mirrored(draw("wi", above()));
        expect_near("the pdf of a direction below", pt::diffuse_pdf(wo, below), 0, 0);
      },
      20);
}

PROMISE(diffuse_bsdf, samples_estimate_the_albedo) {
  for_all(
      [] {
        const Rgb albedo = draw("albedo", any_albedo());
        const Vec3 wo = draw("wo", above());
        std::vector<Rgb> reflected;
        for (const auto& s :
             repeat<pt::diffuse_sample>(4000, draw("seed", sampler_seed()), albedo, wo)) {
          reflected.push_back(s.f * (s.wi.z / s.pdf));
        }
        // f, the pdf and wi may each be off by the contract's precision. The contract allows a
        // standard deviation of one sample as large as the albedo.
        expect_mean("f cos(wi) / pdf", mean_of(reflected), albedo, Noise{albedo},
                    3 * tolerance(albedo));
      },
      20);
}

PROMISE(diffuse_bsdf, draws_from_the_sampler_alone) {
  for (int kind = kFirstBright; kind < kAlbedoKinds; ++kind) {
    for_all(
        [kind] {
          const Rgb albedo = draw("albedo", albedo_of_kind(kind));
          const Vec3 wo = draw("wo", above());
          expect_goes_on(draw("seed", sampler_seed()), [albedo, wo](pt::Sampler& sampler) {
            const Vec3 wi = pt::diffuse_sample(albedo, wo, sampler).wi;
            return Rgb{wi.x, wi.y, wi.z};
          });
        },
        1);
  }
  for_all(
      [] {
        const Rgb albedo = draw("albedo", rc::gen::oneOf(any_albedo(), rc::gen::just(Rgb{})));
        const Vec3 up = draw("wo", above());
        const Vec3 wo = draw("seen from below", rc::gen::arbitrary<bool>()) ? mirrored(up) : up;
        expect_moves_on(draw("seed", sampler_seed()), [=](pt::Sampler& sampler) {
          const Vec3 wi = pt::diffuse_sample(albedo, wo, sampler).wi;
          return Rgb{wi.x, wi.y, wi.z};
        });
      },
      12);
}

}  // namespace
}  // namespace grader::check
