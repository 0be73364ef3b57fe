#pragma once

#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

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

}  // namespace grader::check
