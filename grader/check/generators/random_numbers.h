#pragma once

#include "grader/check/generators/generators.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace grader::check {

// Hundreds of random numbers from one seed that a property draws. This is faster than one value of
// RapidCheck per number. It is enough if only the number of objects has to shrink, not each value.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : sampler_(seed) {}

  double between(double low, double high) { return low + (high - low) * sampler_.next_1d(); }

  // An integer in low .. high, both included.
  int whole(int low, int high) {
    return low + static_cast<int>(sampler_.next_1d() * (high - low + 1));
  }

  // A vector with each component in [low, high].
  pt::Vec3 vector(double low, double high) {
    const double x = between(low, high), y = between(low, high);
    return {x, y, between(low, high)};
  }

  template <class T>
  void shuffle(std::vector<T>& values) {
    for (int i = static_cast<int>(values.size()) - 1; i > 0; --i) {
      std::swap(values[i], values[whole(0, i)]);
    }
  }

 private:
  pt::Sampler sampler_;
};

// A sampler whose number `place` (from 0) is xi; the numbers before and after it are random. So a
// number that is hardly ever drawn, such as 0, can be tried.
inline pt::Sampler sampler_that_draws(double xi, int place, std::uint64_t seed) {
  // The state before number `place` (pt/sampling/sampler.h): the sum of two words makes the number.
  pt::Sampler::State state = pt::Sampler(seed).state();
  const std::uint64_t bits = static_cast<std::uint64_t>(xi * 0x1p53) << 11;
  state[3] = std::rotr(bits - state[0], 23) - state[0];
  // The states before it, one by one: each operation of the generator undone.
  for (int i = 0; i < place; ++i) {
    const auto [a, b, c, d] = state;
    const std::uint64_t mixed = std::rotr(d, 45);
    const std::uint64_t s0 = a ^ mixed, folded = b ^ c;
    const std::uint64_t s1 = folded ^ folded << 17 ^ folded << 34 ^ folded << 51;
    state = {s0, s1, b ^ s1 ^ s0, mixed ^ s1};
  }
  return pt::Sampler(state);
}

// A sampler of which one of the first `places` numbers is hardly ever drawn: `smallest`, the largest
// one, or a number that single precision rounds to 1.
inline pt::Sampler sampler_of_a_rare_number(int places, double smallest = 0) {
  const double xi =
      draw("a rare random number", rc::gen::element(smallest, 1 - 0x1p-53, 1 - 0x1p-26));
  const int place = draw("numbers drawn before it", whole(0, places - 1));
  return sampler_that_draws(xi, place, draw("seed", sampler_seed()));
}

}  // namespace grader::check
