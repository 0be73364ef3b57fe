#include "measure/scene/ladder.h"

#include <algorithm>
#include <cmath>

namespace measure::scene {

namespace {

// A logarithm, as it turns ratios into sums, whose errors are simple.
Uncertain log_of(const Uncertain& value) {
  return {std::log(value.value), value.error / value.value};
}

Uncertain sum(const Uncertain& a, const Uncertain& b) {
  return {a.value + b.value, std::hypot(a.error, b.error)};
}

Uncertain exp_of(const Uncertain& log) {
  return {std::exp(log.value), std::exp(log.value) * log.error};
}

// The mean difference over a few turns. In each turn both were timed side by side.
Uncertain mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  return mean_of(differences);
}

// log of the time of rung j over that of rung k.
Uncertain log_time(const std::vector<RungTurns>& turns, std::size_t base, std::size_t j,
                   std::size_t k) {
  const auto beside = [&](std::size_t a, std::size_t b) -> Uncertain {
    // Compared with itself, the base has no noise, in whichever turns.
    if (a == b) return {0, 0};
    if (a == base) {
      const std::vector<double> zeros(turns[b].log_times.size());
      return mean_difference(zeros, turns[b].log_times);
    }
    if (b == base) {
      const std::vector<double> zeros(turns[a].log_times.size());
      return mean_difference(turns[a].log_times, zeros);
    }
    return mean_difference(turns[a].log_times, turns[b].log_times);
  };
  return j < base && k > base ? sum(beside(j, base), beside(base, k)) : beside(j, k);
}

// The noise of the long renders gives all rungs the same small bias: the smallest of all.
double common_bias2(const std::vector<RungTurns>& turns, std::size_t base) {
  double least = turns[base].bias2.value;
  for (std::size_t k = base; k < turns.size(); ++k) least = std::min(least, turns[k].bias2.value);
  return std::max(least, 0.0);
}

// log of the noise of rung j over that of rung k.
Uncertain log_noise(const Uncertain& j, const Uncertain& k, bool same_picture) {
  if (same_picture) return {0, 0};
  const Uncertain a = log_of(j), b = log_of(k);
  return {a.value - b.value, std::hypot(a.error, b.error)};
}

}  // namespace

std::vector<Climbed> worth_of(const std::vector<Rung>& rungs, const std::vector<RungTurns>& turns) {
  std::size_t base = 0;
  while (rungs[base].same_picture) ++base;
  const double common = common_bias2(turns, base);
  std::vector<Climbed> climbed;
  std::size_t below = 0;  // the last rung that was kept
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    const RungTurns& seen = turns[std::max(k, base)];
    Climbed rung{rungs[k], seen.samples, seen.rays, 0, seen.variance, {1, 0}, {1, 0}, 1, 1};
    // A significant bias is part of the error.
    const Uncertain bias2{seen.bias2.value - common, seen.bias2.error};
    rung.biased = bias2.value > kSignificant * bias2.error;
    if (rung.biased) rung.error2 = sum(seen.variance, bias2);
    rung.heavy_tails = seen.variance.error > kHeavy * seen.variance.value;
    rung.seconds = turns[base].seconds * std::exp(log_time(turns, base, k, base).value);
    const auto beside = [&](std::size_t j) {
      const Uncertain noise = log_noise(climbed[j].error2, rung.error2, k <= base);
      return exp_of(sum(log_time(turns, base, j, k), noise));
    };
    if (k > 0) {
      rung.worth = beside(below);
      rung.in_all = beside(0);
      const auto rays = [](const Climbed& c) { return c.rays * c.error2.value; };
      rung.worth_rays = rays(climbed[below]) / rays(rung);
      rung.in_all_rays = rays(climbed[0]) / rays(rung);
    }
    climbed.push_back(rung);
    if (rungs[k].kept) below = k;
  }
  return climbed;
}

}  // namespace measure::scene
