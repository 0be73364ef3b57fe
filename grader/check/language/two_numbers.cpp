#include "grader/check/language/two_numbers.h"

#include "grader/check/language/fail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace grader::check {

namespace {

constexpr int kMaxSlope = 2100;  // beyond it, the precision of the contracts hides the lines
constexpr int kMaxWaves = 2;     // along the other axis: lines in each half of a divided pixel

struct Complex {
  double re = 0, im = 0;
};

Complex times(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

// e^(2 pi i part)
Complex on_circle(double part) {
  return {std::cos(2 * pt::kPi * part), std::sin(2 * pt::kPi * part)};
}

// A line waves x = slope y + constant, and how many of the pairs lie close to it, as a part of all.
struct Line {
  int slope = 0, waves = 1;
  double part = 0;
};

// Adds up e^(2 pi i (k y - m x)) for each whole k but 0 and m = 1, 2, and returns the largest sum, relative
// to the sum of the weights. Where all pairs lie on m x = k y + constant, it is 1.
Line strongest_line(const std::vector<NumberPair>& pairs) {
  using Sums = std::vector<Complex>;
  std::array<Sums, kMaxWaves> up, down;  // by m; of k = 1, 2, ... and of k = -1, -2, ...
  up.fill(Sums(kMaxSlope));
  down.fill(Sums(kMaxSlope));
  double all = 0;
  for (const NumberPair& pair : pairs) {
    const Complex step = on_circle(pair.y);
    std::array<Complex, kMaxWaves> starts;
    for (int m = 1; m <= kMaxWaves; ++m) starts[m - 1] = on_circle(-m * pair.x);
    Complex turned = {pair.weight * step.re, pair.weight * step.im};
    for (std::size_t i = 0; i < kMaxSlope; ++i) {
      for (std::size_t m = 0; m < kMaxWaves; ++m) {
        // start times turned, and times its conjugate
        const double rr = starts[m].re * turned.re, ii = starts[m].im * turned.im;
        const double ri = starts[m].re * turned.im, ir = starts[m].im * turned.re;
        up[m][i].re += rr - ii;
        up[m][i].im += ri + ir;
        down[m][i].re += rr + ii;
        down[m][i].im += ir - ri;
      }
      turned = times(turned, step);
    }
    all += pair.weight;
  }
  Line strongest;
  for (std::size_t m = 0; m < kMaxWaves; ++m) {
    for (int k = 1; k <= kMaxSlope; ++k) {
      for (const int sign : {1, -1}) {
        const Complex sum = (sign > 0 ? up : down)[m][static_cast<std::size_t>(k - 1)];
        const double part = std::hypot(sum.re, sum.im) / all;
        if (!(part <= strongest.part)) strongest = {sign * k, static_cast<int>(m) + 1, part};
      }
    }
  }
  return strongest;
}

NumberPair exchanged(NumberPair pair) { return {pair.y, pair.x, pair.weight}; }

// If one number is uniform whatever the other is, each term of a sum has the mean 0. A sum of real
// terms of up to w_i exceeds t sqrt(sum w_i^2) with a probability of 2 exp(-t^2 / 2) at most
// (Hoeffding 1963). A complex sum that exceeds r has a real or an imaginary part above r / sqrt(2).
double largest_by_chance(const std::vector<NumberPair>& pairs) {
  constexpr double kSums = 2.0 * kMaxWaves * 2 * kMaxSlope;
  double all = 0, squares = 0;
  for (const NumberPair& pair : pairs) {
    all += pair.weight;
    squares += pair.weight * pair.weight;
  }
  return 2 * std::sqrt(squares * std::log(4 * kSums / 1e-9)) / all;
}

// True if the y of two pairs differ by less than a tenth, on a circle of length 1.
bool close_in_y(const NumberPair& a, const NumberPair& b) {
  const double apart = std::abs(a.y - b.y);
  return std::min(apart, 1 - apart) < 0.1;
}

// Returns how much more often two pairs are close in y if they are two of the 150 neighbours that are
// closest in x. If y follows from x, by whatever curve, it is nearly always so. If it does not, the
// result exceeds 0.3 once in 5e11 times (Hoeffding 1963).
double closer_than_others(std::vector<NumberPair> pairs) {
  constexpr std::size_t kClosest = 150;
  std::ranges::stable_sort(pairs, {}, &NumberPair::x);
  const std::size_t n = pairs.size();
  double all = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) all += close_in_y(pairs[i], pairs[j]);
  }
  std::vector<std::pair<double, std::size_t>> gaps;
  for (std::size_t i = 0; i + 1 < n; ++i) gaps.emplace_back(pairs[i + 1].x - pairs[i].x, i);
  if (gaps.size() < 4 * kClosest) return 0;
  std::ranges::sort(gaps);
  double closest = 0;
  for (std::size_t i = 0; i < kClosest; ++i) {
    const std::size_t first = gaps[i].second;
    closest += close_in_y(pairs[first], pairs[first + 1]);
  }
  return closest / kClosest - 2 * all / (static_cast<double>(n) * static_cast<double>(n - 1));
}

// True if neighbours can be found, and no pair counts for more than another.
bool can_be_sorted(const std::vector<NumberPair>& pairs) {
  return std::ranges::all_of(pairs, [&](const NumberPair& p) {
    const bool is_equal = std::abs(p.weight - pairs[0].weight) < 1e-4 * std::abs(p.weight);
    return is_equal && std::isfinite(p.x) && std::isfinite(p.y);
  });
}

}  // namespace

void expect_two_numbers(const std::string& what, const std::vector<NumberPair>& pairs) {
  const std::string wanted = "two random numbers that do not depend on each other";
  const double by_chance = largest_by_chance(pairs);
  std::vector<NumberPair> other_way(pairs.size());
  std::ranges::transform(pairs, other_way.begin(), exchanged);
  for (const bool other : {false, true}) {
    const Line found = strongest_line(other ? other_way : pairs);
    if (found.part <= by_chance) continue;
    fail_statistical(what,
                     fmt::format("one that follows from the other: it is {:.4g} times it, but for "
                                 "whole numbers",
                                 static_cast<double>(found.slope) / found.waves),
                     wanted);
  }
  if (!can_be_sorted(pairs)) return;
  if (closer_than_others(pairs) <= 0.3 && closer_than_others(other_way) <= 0.3) return;
  fail_statistical(what,
                   "one that follows from the other: where one is nearly the same, so is the other",
                   wanted);
}

}  // namespace grader::check
