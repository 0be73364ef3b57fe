#pragma once

#include "measure/calls/subject.h"
#include "pt/sampling/sampler.h"

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

}  // namespace measure::calls
