#pragma once

#include "pt/math/frame.h"
#include "pt/sampling/sampler.h"
#include "tests/proof/statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

// Chi-square tests of direction sampling: counts in bins, compared with the integral of the density
// over each bin.

namespace pt::proof {

inline constexpr int kHeights = 20, kAngles = 24;

// Bins of equal solid angle around an axis, where 1 - cos runs from 0 to `reach`.
struct Bins {
  Frame frame;
  double reach = 2;

  int of(Vec3 w) const {
    const Vec3 local = frame.to_local(w);
    // Computing 1 - z from the sine keeps its digits in a narrow cone.
    const double squared = local.x * local.x + local.y * local.y;
    const double h = local.z > 0 ? squared / (1 + local.z) : 1 - local.z;
    double turn = std::atan2(local.y, local.x) / (2 * kPi);
    turn -= std::floor(turn);
    const int height = std::min(kHeights - 1, static_cast<int>(h / reach * kHeights));
    return height * kAngles + std::min(kAngles - 1, static_cast<int>(turn * kAngles));
  }

  // The integral of the density over each bin, from 40 x 40 points per bin.
  std::vector<double> integrals(const std::function<double(Vec3)>& density) const {
    constexpr int kFine = 40;
    std::vector<double> sums(kHeights * kAngles);
    const double cell = 2 * kPi * reach / (kHeights * kAngles * kFine * kFine);
    for (int i = 0; i < kHeights * kFine; ++i) {
      for (int j = 0; j < kAngles * kFine; ++j) {
        const Vec2 xi{(i + 0.5) / (kHeights * kFine), (j + 0.5) / (kAngles * kFine)};
        const Vec3 w = frame.to_world(uniform_cone_by_hand(xi));
        sums[(i / kFine) * kAngles + j / kFine] += cell * density(w);
      }
    }
    return sums;
  }

  Vec3 uniform_cone_by_hand(Vec2 xi) const {
    const double h = xi.x * reach;
    const double r = std::sqrt(h * (2 - h));
    return {r * std::cos(2 * kPi * xi.y), r * std::sin(2 * kPi * xi.y), 1 - h};
  }
};

inline void expect_density(const Bins& bins, const std::function<Vec3(Sampler&)>& draw,
                           const std::function<double(Vec3)>& density, const std::string& what) {
  const int n = 200000;
  Sampler sampler(51);
  std::vector<double> counts(kHeights * kAngles);
  for (int i = 0; i < n; ++i) {
    const Vec3 w = draw(sampler);
    ASSERT_NEAR(length(w), 1, 1e-14) << what;
    ++counts[bins.of(w)];
  }
  std::vector<double> expected = bins.integrals(density);
  for (double& mean : expected) mean *= n;
  expect_counts(counts, expected, what);
}

}  // namespace pt::proof
