#pragma once

#include "measure/calls/subject.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace measure::calls {

inline constexpr int kInputs =
    4096;  // some 800 KiB of triangles and rays, which fit in the L2 cache

// A sum of all answers goes here, so that the compiler cannot leave a call out if it sees the
// function.
inline volatile double sink = 0;

// A task with an exact answer: call(input) returns the answer, look(input, answer, found) enters
// its errors and counts wrong answers.
template <class Input, class Call, class Look>
Subject exact_subject(std::vector<Input> all, Call call, Look look) {
  const auto inputs = std::make_shared<const std::vector<Input>>(std::move(all));
  const auto pass = [inputs, call] {
    double sum = 0;
    for (const Input& input : *inputs) {
      const auto answer = call(input);
      sum += reinterpret_cast<const unsigned char&>(answer);
    }
    sink = sum;
  };
  const auto find = [inputs, call, look](std::uint64_t) {
    Found found;
    for (const Input& input : *inputs) look(input, call(input), found);
    found.wrong /= static_cast<double>(inputs->size());
    return found;
  };
  return {static_cast<int>(inputs->size()), pass, find};
}

// Makes inputs until there are enough: make(sampler) returns an input, or nothing if it is so near
// to a border that the right answer is not unique.
template <class Make>
auto make_inputs(std::uint64_t seed, Make make) {
  pt::Sampler sampler(seed);
  std::vector<typename decltype(make(sampler))::value_type> all;
  while (all.size() < kInputs) {
    if (auto input = make(sampler)) all.push_back(*input);
  }
  return all;
}

// Random numbers for inputs.

inline double between(double low, double high, pt::Sampler& sampler) {
  return low + (high - low) * sampler.next_1d();
}

// From 10^low to 10^high, with a uniform logarithm.
inline double size_between(double low, double high, pt::Sampler& sampler) {
  return std::pow(10, between(low, high, sampler));
}

inline pt::Vec3 in_cube(double half, pt::Sampler& sampler) {
  const double x = between(-half, half, sampler), y = between(-half, half, sampler);
  return {x, y, between(-half, half, sampler)};
}

// A direction of unit length, uniform over the sphere.
inline pt::Vec3 any_direction(pt::Sampler& sampler) {
  const double z = between(-1, 1, sampler), angle = between(0, 2 * pt::kPi, sampler);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Never NaN: a result that is not a number counts as the largest error.
inline void keep_largest(double& largest, long double error) {
  const auto size = static_cast<double>(std::abs(error));
  largest = size >= 0 ? std::max(largest, size) : pt::kInfinity;
}

// Rays that are aimed at shapes.

inline constexpr long double kMargin =
    0.01L;  // of barycentric coordinates and of a radius, to avoid borders

template <class Shape>
struct Aimed {
  Shape shape;
  pt::Ray ray;
  bool hits = false;
};

// A ray towards `target`, with a direction of any length.
inline pt::Ray ray_towards(pt::Vec3 origin, pt::Vec3 target, pt::Sampler& sampler) {
  pt::Ray ray;
  ray.origin = origin;
  ray.direction = size_between(-3, 3, sampler) * normalize(target - origin);
  return ray;
}

}  // namespace measure::calls
