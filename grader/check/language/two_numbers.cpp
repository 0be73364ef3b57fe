#include "grader/check/language/two_numbers.h"

#include "grader/check/language/fail.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace grader::check {

namespace {

constexpr int kMaxSlope = 2100;  // beyond it, the precision of the contracts hides the lines
constexpr int kMaxWaves = 2;     // along the other axis: lines in each half of a divided pixel

constexpr std::size_t kPlaces = 16384;  // of y: a power of 2, far above 2 kMaxSlope

using Complex = std::complex<double>;

// e^(2 pi i part)
Complex on_circle(double part) { return std::polar(1.0, 2 * pt::kPi * part); }

// The fraction of a number, from 0 to 1.
double fraction(double x) { return x - std::floor(x); }

// Turns kPlaces values v_j into the sums of v_j e^(2 pi i k j / kPlaces), for each k: the fast Fourier
// transform of Stockham (1966), which keeps the order.
std::vector<Complex> fourier_sums(std::vector<Complex> values) {
  static const std::vector<Complex> roots = [] {
    std::vector<Complex> all;
    for (std::size_t i = 0; i < kPlaces; ++i) all.push_back(on_circle(double(i) / kPlaces));
    return all;
  }();
  std::vector<Complex> next(kPlaces);
  for (std::size_t step = 1, half = kPlaces / 2; half > 0; step *= 2, half /= 2) {
    for (std::size_t i = 0; i < kPlaces / 2; ++i) {
      const std::size_t turns = i / step * step;
      const Complex a = values[i], b = values[i + kPlaces / 2];
      next[i + turns] = a + b;
      next[i + turns + step] = (a - b) * roots[turns];
    }
    values.swap(next);
  }
  return values;
}

// A line waves x = slope y + constant, and how many of the pairs lie close to it, as a part of all.
struct Line {
  int slope = 0, waves = 1;
  double part = 0;
};

// Adds up e^(2 pi i (k y - m x)) for each whole k but 0 and m = 1, 2, and returns the largest sum, relative
// to the sum of the weights. Where all pairs lie on m x = k y + constant, it is 1. Each y is taken for the
// next of kPlaces below it, which makes the sum of a steep line less by up to 3 %.
Line strongest_line(const std::vector<NumberPair>& pairs) {
  double all = 0;
  for (const NumberPair& pair : pairs) all += pair.weight;
  Line strongest;
  for (int m = 1; m <= kMaxWaves; ++m) {
    std::vector<Complex> at_places(kPlaces);
    for (const NumberPair& pair : pairs) {
      const auto place = static_cast<std::size_t>(fraction(pair.y) * kPlaces) % kPlaces;
      at_places[place] += pair.weight * on_circle(-m * pair.x);
    }
    const std::vector<Complex> sums = fourier_sums(std::move(at_places));
    for (int k = 1; k <= kMaxSlope; ++k) {
      for (const int slope : {k, -k}) {  // a negative one is counted from the end
        const double part = std::abs(sums[static_cast<std::size_t>(slope) % kPlaces]) / all;
        if (!(part <= strongest.part)) strongest = {slope, m, part};
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

// Numbers on a circle of length 1 are close if they differ by less than a tenth.
constexpr double kClose = 0.1;

bool close_in_y(const NumberPair& a, const NumberPair& b) {
  const double apart = fraction(a.y - b.y);
  return std::min(apart, 1 - apart) < kClose;
}

// The number of pairs of pairs that are close in y.
double number_close(const std::vector<NumberPair>& pairs) {
  std::vector<double> around;  // twice around the circle
  for (const NumberPair& pair : pairs) around.push_back(fraction(pair.y));
  std::ranges::sort(around);
  const std::size_t n = pairs.size();
  for (std::size_t i = 0; i < n; ++i) around.push_back(around[i] + 1);
  double close = 0;
  for (std::size_t i = 0, end = 0; i < n; ++i) {
    while (end < 2 * n && around[end] - around[i] < kClose) ++end;
    close += static_cast<double>(end - i - 1);
  }
  return close;
}

// Returns how much more often two pairs are close in y if they are two of the 150 neighbours that are
// closest in x. If y follows from x, by whatever curve, it is nearly always so. If it does not, the
// result exceeds 0.3 once in 5e11 times (Hoeffding 1963).
double closer_than_others(std::vector<NumberPair> pairs) {
  constexpr std::size_t kClosest = 150;
  std::ranges::stable_sort(pairs, {}, &NumberPair::x);
  const std::size_t n = pairs.size();
  std::vector<std::pair<double, std::size_t>> gaps;
  for (std::size_t i = 0; i + 1 < n; ++i) gaps.emplace_back(pairs[i + 1].x - pairs[i].x, i);
  if (gaps.size() < 4 * kClosest) return 0;
  std::ranges::sort(gaps);
  double closest = 0;
  for (std::size_t i = 0; i < kClosest; ++i) {
    const std::size_t first = gaps[i].second;
    closest += close_in_y(pairs[first], pairs[first + 1]);
  }
  return closest / kClosest -
         2 * number_close(pairs) / (static_cast<double>(n) * static_cast<double>(n - 1));
}

// True if no pair counts for more than another.
bool have_one_weight(const std::vector<NumberPair>& pairs) {
  return std::ranges::all_of(pairs, [&](const NumberPair& p) {
    return std::abs(p.weight - pairs[0].weight) < 1e-4 * std::abs(p.weight);
  });
}

}  // namespace

void expect_two_numbers(const std::string& what, const std::vector<NumberPair>& pairs) {
  const std::string wanted = "two random numbers that do not depend on each other";
  const bool are_finite = std::ranges::all_of(
      pairs, [](const NumberPair& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  if (!are_finite) fail(what, "a number that is not finite", wanted);
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
  if (!have_one_weight(pairs)) return;
  if (closer_than_others(pairs) <= 0.3 && closer_than_others(other_way) <= 0.3) return;
  fail_statistical(what,
                   "one that follows from the other: where one is nearly the same, so is the other",
                   wanted);
}

}  // namespace grader::check
