#pragma once

#include "pt/math/vec3.h"

#include <array>
#include <bit>
#include <cstdint>

namespace pt {

// A stream of independent numbers, uniform in [0, 1): textbooks call them xi. A sampler is small
// and can be copied. The same seed gives the same numbers on every machine. The generator is
// xoshiro256++ (Blackman and Vigna 2021, Scrambled Linear Pseudorandom Number Generators), its
// state filled by SplitMix64 (Steele, Lea and Flood 2014).
class Sampler {
 public:
  using State = std::array<std::uint64_t, 4>;

  explicit Sampler(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9e3779b97f4a7c15;
      word = mix(seed);
    }
  }

  // Continues from the state of another sampler.
  explicit Sampler(const State& state) : state_(state) {}
  const State& state() const { return state_; }

  // The stream of one pixel: independent of the order in which pixels are rendered.
  static Sampler for_pixel(std::uint64_t seed, int x, int y) {
    const auto pixel = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) |
                       static_cast<std::uint32_t>(x);
    return Sampler(mix(mix(seed + 0x9e3779b97f4a7c15) ^ mix(pixel)));
  }

  double next_1d() { return static_cast<double>(next_bits() >> 11) * 0x1p-53; }

  Vec2 next_2d() {
    const double x = next_1d();
    const double y = next_1d();
    return {x, y};
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t next_bits() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  State state_{};
};

}  // namespace pt
