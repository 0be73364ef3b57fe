#pragma once

#include "pt/sampling/sampler.h"

#include <cstdint>
#include <vector>

namespace grader {

// `n` independent calls of a task whose last parameter is a Sampler&, for a statistical promise:
//   repeat<pt::direct_lights>(10000, seed, scene, point, samples)
// returns what the calls returned; call i gets Sampler::for_pixel(seed, i, 0).
template <auto Task, class... Arguments>
auto repeat(int n, std::uint64_t seed, const Arguments&... arguments) {
  using Result = decltype(Task(arguments..., std::declval<pt::Sampler&>()));
  std::vector<Result> results;
  results.reserve(n);
  for (int i = 0; i < n; ++i) {
    pt::Sampler sampler = pt::Sampler::for_pixel(seed, i, 0);
    results.push_back(Task(arguments..., sampler));
  }
  return results;
}

}  // namespace grader
