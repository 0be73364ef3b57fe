#pragma once

#include "grader/check/wild/direct_call.h"
#include "grader/tasks/direct_hemisphere/inputs.h"
#include "pt/tasks/direct_hemisphere.h"

#include <array>

// Calls of direct_hemisphere that are explained one by one.

namespace grader::check::direct_hemisphere_inputs {

using Hemisphere = DirectCall<&pt::direct_hemisphere, &explain::explain_hemisphere, 1>;

// Few of them are long: a long call is as good as many short ones for most mistakes, and the others are limits.
inline int wild_samples(RandomNumbers& random) {
  const int kind = random.whole(1, 3000);
  if (kind <= 3) return 5000;
  if (kind <= 30) return 100;
  return std::array{1, 1, 1, 1, 2, 2, 3, 5, 8, 16, 16, 30}[random.whole(0, 11)];
}

inline Explanations usual_calls(std::uint64_t seed) {
  constexpr int kScenes = 40;
  Explanations all;
  const auto add = [&](const rc::Gen<Situation>& generator, int i) {
    add_usual_calls(all, generator, Hemisphere{1 + 5 * (i % 4)}, i, seed);
  };
  for (int i = 0; i < kScenes; i += 4) {
    add(in_a_glowing_room(pose(1)), i);
    add(under_a_rectangle(pose(), rc::gen::just(0.0)), i + 1);
    add(under_the_sky(), i + 2);
    add(smoothly_shaded_under_a_lamp(), i + 3);
  }
  return all;
}

inline WildTask wild_task() {
  return {usual_calls, [](RandomNumbers& random) {
            const WildScene scene = wild_scene(random, false);
            return SceneCall<Hemisphere>::make(scene, {wild_samples(random)});
          }};
}

// A record says nothing about how likely its directions were. Other promises judge that.
inline bool needs_no_mean(const Situation& s, int samples) {
  const Hemisphere asks{samples};
  return check::needs_no_mean(
      wild_task(), [&](int n) { return asks.ask(s, n, draw("seed", sampler_seed())); }, samples);
}

}  // namespace grader::check::direct_hemisphere_inputs
