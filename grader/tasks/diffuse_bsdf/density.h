#pragma once

#include "grader/check/generators/directions_found.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/language/repetition.h"
#include "grader/check/language/two_numbers.h"
#include "grader/tasks/diffuse_bsdf/inputs.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

// Compares many samples of diffuse_sample with the density that diffuse_pdf gives.

namespace grader::check::diffuse_bsdf_inputs {

// A histogram over the hemisphere. It has kHeights times kSectors cells of equal solid angle.
inline constexpr int kHeights = 16, kSectors = 8, kSamples = 16000;

// The number of samples per cell that the pdf predicts. Each cell is cut into thin rings, because
// the pdf may vary with the height.
inline std::vector<DirectionCell> expected_by_pdf(Vec3 wo) {
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

// Says where the expected numbers come from, and whether they can be right.
inline std::string by_the_pdf(const std::vector<DirectionCell>& cells) {
  double sum = 0;
  for (const DirectionCell& cell : cells) sum += cell.expected / kSamples;
  const bool is_one = std::abs(sum - 1) < 5e-3;
  return is_one ? ", by your diffuse_pdf"
                : fmt::format(", by your diffuse_pdf (which sums to {:.3g}, not 1)", sum);
}

// Counts the samples in each cell. Samples below the surface are in no cell.
inline void count_samples(std::vector<DirectionCell>& cells,
                          const std::vector<pt::BsdfSample>& samples) {
  for (const pt::BsdfSample& sample : samples) {
    const double turn = std::atan2(sample.wi.y, sample.wi.x) / (2 * pt::kPi);
    const double i = std::min(kHeights * sample.wi.z, kHeights - 0.5);
    const double j = kSectors * (turn < 0 ? turn + 1 : turn);
    if (!(i >= 0 && j >= 0 && j < kSectors)) continue;
    ++cells[static_cast<std::size_t>(i) * kSectors + static_cast<std::size_t>(j)].found;
  }
}

// Samples of a continuous density are different from each other. Fails if one direction comes more than
// four times, or if more than half of the samples have the same azimuth as another one, or the same
// height, to a millionth.
inline void expect_different_samples(const std::vector<pt::BsdfSample>& samples) {
  const auto place = [](double a) { return std::lround(1e6 * a); };
  std::vector<std::array<long, 3>> directions;
  std::vector<long> heights, azimuths;
  for (const auto& [wi, f, pdf] : samples) {
    directions.push_back({place(wi.x), place(wi.y), place(wi.z)});
    heights.push_back(place(wi.z));
    azimuths.push_back(place(std::atan2(wi.y, wi.x)));
  }
  const std::string wanted = fmt::format("{} samples of a continuous density", samples.size());
  const Repetition repeated = repetition(directions);
  expect(!repeated.one_is_frequent(), wanted, fmt::format("one direction {} times", repeated.most));
  const auto expect_different = [&](const std::vector<long>& places, const char* what) {
    const Repetition of_places = repetition(places);
    expect(!of_places.half_are_repeated(), wanted,
           fmt::format("only {} different {}", of_places.different, what));
  };
  expect_different(heights, "heights above the surface");
  expect_different(azimuths, "angles around the normal");
}

// Whatever the density is, all angles around the normal are equally likely at every height, if a sample
// counts in proportion to cos(wi) / pdf.
inline void expect_independent_angles(const std::vector<pt::BsdfSample>& samples) {
  // Uniform samples have a uniform height, and cosine-weighted ones a uniform squared height.
  for (const bool is_squared : {false, true}) {
    std::vector<NumberPair> pairs;
    for (const auto& [wi, f, pdf] : samples) {
      if (!(pdf > 0)) continue;
      const double angle = std::atan2(wi.y, wi.x) / (2 * pt::kPi);
      pairs.push_back({is_squared ? wi.z * wi.z : wi.z, angle, wi.z / (pt::kPi * pdf)});
    }
    expect_two_numbers("the height of a sample and its angle around the normal", pairs);
  }
}

// Cosine-weighted samples are so rare close to the horizon that the histogram shows little there.
// This counts more of them, below 3.6 degrees and below 1.1. The pdf is integrated in thin rings.
inline void expect_samples_close_to_the_horizon(Rgb albedo, Vec3 wo, std::uint64_t seed) {
  constexpr int kManySamples = 200000, kRings = 16;
  const auto samples = repeat<pt::diffuse_sample>(kManySamples, seed, albedo, wo);
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

}  // namespace grader::check::diffuse_bsdf_inputs
