#include "grader/check/closed_forms.h"
#include "grader/check/directions_found.h"
#include "grader/check/generators.h"
#include "grader/check/in_a_row.h"
#include "grader/check/property.h"
#include "grader/check/repeat.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::check {
namespace {

using pt::Rgb;
using pt::Vec3;

Vec3 at(double z, double phi) {
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// A unit direction above the surface, steep or grazing, or the normal itself.
rc::Gen<Vec3> above() {
  const auto height = rc::gen::oneOf(real(1e-3, 1), magnitude(1e-9, 1), rc::gen::just(1.0));
  return rc::gen::map(rc::gen::pair(height, real(-pt::kPi, pt::kPi)),
                      [](const std::pair<double, double>& p) { return at(p.first, p.second); });
}

// An albedo of any colour, or with channels of 0, 1e-4, 1/2 or 1.
rc::Gen<Rgb> any_albedo() {
  const auto special = rc::gen::element(0.0, 1e-4, 0.5, 1.0);
  return rc::gen::oneOf(color(),
                        rc::gen::map(rc::gen::tuple(special, special, special),
                                     [](const std::tuple<double, double, double>& c) {
                                       return Rgb{std::get<0>(c), std::get<1>(c), std::get<2>(c)};
                                     }));
}

// The error that the contract allows for a value of this size.
double tolerance(Rgb size) { return kColorPrecision * max_channel(size); }

Vec3 mirrored(Vec3 w) { return {w.x, w.y, -w.z}; }

// The centres of cells that divide the hemisphere into equal solid angles.
std::vector<Vec3> grid(int heights, int sectors) {
  std::vector<Vec3> directions;
  for (int i = 0; i < heights; ++i) {
    for (int j = 0; j < sectors; ++j) {
      directions.push_back(at((i + 0.5) / heights, 2 * pt::kPi * (j + 0.5) / sectors));
    }
  }
  return directions;
}

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
}

// Any constant is the same for all directions. So f has to be a BSDF of the albedo, at least to a
// factor of ten; the promise f_reflects_the_albedo judges its size.
void expect_some_reflection(Rgb albedo, Rgb f) {
  const double part = max_channel(f) * pt::kPi;
  expect(is_black(albedo) || (part > max_channel(albedo) / 10 && part < max_channel(albedo) * 10),
         "an f of a tenth to ten times albedo / pi", "f is " + show(f));
}

PROMISE(diffuse_bsdf, f_is_the_same_for_all_directions) {
  for_all([] {
    const Rgb albedo = draw("albedo", any_albedo());
    const Vec3 wo = draw("wo", above()), wi = draw("wi", above());
    const Rgb along_the_normal = pt::diffuse_f(albedo, {0, 0, 1}, {0, 0, 1});
    expect_some_reflection(albedo, along_the_normal);
    expect_near("f, and f along the normal", pt::diffuse_f(albedo, wo, wi), along_the_normal,
                tolerance(albedo));
  });
}

PROMISE(diffuse_bsdf, f_is_zero_across_the_surface) {
  for_all([] {
    const Rgb albedo = draw("albedo", color(0.25, 1));
    const Vec3 wo = draw("wo", above()), wi = draw("wi", above());
    expect_near("f to below", pt::diffuse_f(albedo, wo, mirrored(wi)), {}, 0);
    expect_near("f from below", pt::diffuse_f(albedo, mirrored(wo), wi), {}, 0);
    const Rgb above_it = pt::diffuse_f(albedo, wo, wi);
    expect_some_reflection(albedo, above_it);
    expect_near("f with both below, and f with both above",
                pt::diffuse_f(albedo, mirrored(wo), mirrored(wi)), above_it, tolerance(albedo));
  });
}

PROMISE(diffuse_bsdf, samples_the_side_of_wo) {
  for_all(
      [] {
        const Rgb albedo = draw("albedo", any_albedo());
        const Vec3 wo = draw("wo", above());
        const auto samples =
            repeat<pt::diffuse_sample>(2000, draw("seed", sampler_seed()), albedo, wo);
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
          expect(found[i] > 0, "2000 samples in all directions, steep and flat",
                 fmt::format("none {} than 60 degrees from the normal, {} to {} degrees around it",
                             i % 2 == 0 ? "less" : "more", from, from + 45));
        }
      },
      10);
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

// A histogram over the hemisphere. It has kHeights times kSectors cells of equal solid angle.
constexpr int kHeights = 16, kSectors = 8, kSamples = 20000;

// The number of samples per cell that the pdf predicts. Each cell is cut into thin rings, because
// the pdf may vary with the height.
std::vector<DirectionCell> expected_by_pdf(Vec3 wo) {
  constexpr int kRings = 2;
  std::vector<DirectionCell> cells;
  for (int i = 0; i < kHeights; ++i) {
    for (int j = 0; j < kSectors; ++j) {
      const double phi = 2 * pt::kPi * (j + 0.5) / kSectors;
      DirectionCell cell{at((i + 0.5) / kHeights, phi)};
      for (int ring = 0; ring < kRings; ++ring) {
        const Vec3 wi = at((i + (ring + 0.5) / kRings) / kHeights, phi);
        cell.expected +=
            kSamples * pt::diffuse_pdf(wo, wi) * 2 * pt::kPi / (kHeights * kSectors * kRings);
      }
      cells.push_back(cell);
    }
  }
  return cells;
}

// Counts the samples in each cell. Samples below the surface are in no cell.
void count_samples(std::vector<DirectionCell>& cells, Vec3 wo, std::uint64_t seed) {
  for (const auto& sample : repeat<pt::diffuse_sample>(kSamples, seed, pt::gray(0.5), wo)) {
    const double turn = std::atan2(sample.wi.y, sample.wi.x) / (2 * pt::kPi);
    const double i = std::min(kHeights * sample.wi.z, kHeights - 0.5);
    const double j = kSectors * (turn < 0 ? turn + 1 : turn);
    if (!(i >= 0 && j >= 0 && j < kSectors)) continue;
    ++cells[static_cast<std::size_t>(i) * kSectors + static_cast<std::size_t>(j)].found;
  }
}

// Cosine-weighted samples are so rare close to the horizon that the histogram shows little there.
// This counts more of them, below 3.6 degrees and below 1.1. The pdf is integrated in thin rings.
void expect_samples_close_to_the_horizon(Vec3 wo, std::uint64_t seed) {
  constexpr int kManySamples = 240000, kRings = 16;
  const auto samples = repeat<pt::diffuse_sample>(kManySamples, seed, pt::gray(0.5), wo);
  for (const double highest : {0.0625, 0.02}) {
    double expected = 0, found = 0;
    for (int ring = 0; ring < kRings; ++ring) {
      const Vec3 wi = at(highest * (ring + 0.5) / kRings, ring);
      expected += kManySamples * pt::diffuse_pdf(wo, wi) * 2 * pt::kPi * highest / kRings;
    }
    for (const pt::BsdfSample& s : samples) found += s.wi.z > 0 && s.wi.z < highest;
    // Less than one right count in a billion is outside: it is a Poisson variable, and the sum over
    // rings is a few percent off where the density is steep.
    const double by_chance = 6.5 * std::sqrt(expected) + 6 + 0.03 * expected;
    expect_near(
        fmt::format("how many of {} directions are less than {:.1f} degrees above the surface",
                    kManySamples, std::asin(highest) * 180 / pt::kPi),
        found, expected, by_chance);
  }
}

PROMISE(diffuse_bsdf, pdf_is_the_density_of_the_samples) {
  for_all(
      [] {
        const Vec3 wo = draw("wo", above());
        std::vector<DirectionCell> cells = expected_by_pdf(wo);
        count_samples(cells, wo, draw("seed", sampler_seed()));
        expect_spread(cells);
      },
      4);
  for_all(
      [] {
        const Vec3 wo = draw("wo", above());
        expect_samples_close_to_the_horizon(wo, draw("seed", sampler_seed()));
      },
      1);
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

PROMISE(diffuse_bsdf, goes_on_with_the_sampler) {
  for_all(
      [] {
        const Vec3 wo = draw("wo", above());
        expect_goes_on(draw("seed", sampler_seed()), [wo](pt::Sampler& sampler) {
          const Vec3 wi = pt::diffuse_sample(pt::gray(0.5), wo, sampler).wi;
          return Rgb{wi.x, wi.y, wi.z};
        });
      },
      3);
}

}  // namespace
}  // namespace grader::check
