#pragma once

#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace grader::check {

// Random numbers by the hundred, from one seed that a property draws: faster than as many values of
// RapidCheck, and enough where it is their number that has to shrink and not each of them.
class Many {
 public:
  explicit Many(std::uint64_t seed) : sampler_(seed) {}

  double between(double low, double high) { return low + (high - low) * sampler_.next_1d(); }

  // In low .. high, both included.
  int whole(int low, int high) {
    return low + static_cast<int>(sampler_.next_1d() * (high - low + 1));
  }

  // Each component in [low, high].
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
