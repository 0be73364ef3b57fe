#pragma once

#include "grader/tasks/trace_path/estimates.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

// Pairs of estimates from one sampler.

namespace grader::check::trace_path_inputs {

inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double products = 0, squares_a = 0, squares_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    products += (a[i] - mean_a) * (b[i] - mean_b);
    squares_a += (a[i] - mean_a) * (a[i] - mean_a);
    squares_b += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return products / std::sqrt(squares_a * squares_b);
}

// Fails the case if an estimate does not move the sampler, if two estimates in a row are not independent,
// or if an estimate of `before` changes the next one of `c`.
inline void expect_independent_pairs(const Case& c, const Case& before) {
  constexpr int kPairs = 300;
  const auto estimate = [](const Case& one, pt::Sampler& sampler) {
    return pt::trace_path(one.room.scene, one.room.point, one.settings, sampler);
  };
  std::vector<double> firsts, seconds;
  for (int i = 0; i < kPairs; ++i) {
    const pt::Sampler start = pt::Sampler::for_pixel(c.seed, i, 1);
    pt::Sampler sampler = start;
    const Rgb first = estimate(c, sampler);
    expect(sampler.state() != start.state(), "the sampler moved on", "as it was");
    const Rgb second = estimate(c, sampler);
    expect(first.g != second.g, "two estimates that differ, one after the other", "twice the same");
    if (i < 10) {
      pt::Sampler again = start;
      estimate(before, sampler);
      expect_near("the same estimate again", estimate(c, again), first, 0);
    }
    firsts.push_back(first.g);
    seconds.push_back(second.g);
  }
  const double found = correlation(firsts, seconds);
  expect(std::abs(found) < kStandardErrors / std::sqrt(kPairs), "two independent estimates",
         fmt::format("a correlation of {:.2g}", found));
}

}  // namespace grader::check::trace_path_inputs
