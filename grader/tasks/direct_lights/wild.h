#pragma once

#include "grader/check/wild/direct_call.h"
#include "grader/tasks/direct_lights/inputs.h"
#include "pt/tasks/direct_lights.h"

#include <array>

// Calls of direct_lights that are explained one by one.

namespace grader::check::direct_lights_inputs {

using Lights = DirectCall<&pt::direct_lights, &explain::explain_lights, 2>;

// Few of them are long: what a long call asks for is kept and sent.
inline int wild_samples(RandomNumbers& random) {
  const int kind = random.whole(1, 2000);
  if (kind == 1) return 3000;
  if (kind <= 8) return 300;
  if (kind <= 20) return 100;
  return std::array{1, 1, 1, 2, 2, 3, 3, 5, 5, 8, 16, 30}[random.whole(0, 11)];
}

inline Explanations usual_calls(std::uint64_t seed) {
  constexpr int kScenes = 40;
  Explanations all;
  const auto add = [&](const rc::Gen<Situation>& generator, int i) {
    add_usual_calls(all, generator, Lights{1 + 5 * (i % 3)}, i, seed);
  };
  for (int i = 0; i < kScenes; i += 4) {
    add(lit_by([](SceneMaker& maker) {
          for (int k = 0; k < 3; ++k) any_light(maker);
        }),
        i);
    add(lit_by(lamp_with_a_body), i + 1);
    add(under_the_sky(1.2), i + 2);
    add(lit_and_smoothly_shaded(), i + 3);
  }
  return all;
}

inline WildTask wild_task() {
  return {usual_calls, [](RandomNumbers& random) {
            const WildScene scene = wild_scene(random, false);
            return SceneCall<Lights>::make(scene, {wild_samples(random)});
          }};
}

inline bool needs_no_mean(const Situation& s, int samples) {
  const Lights asks{samples};
  return check::needs_no_mean(
      wild_task(), [&](int n) { return asks.ask(s, n, draw("seed", sampler_seed())); },
      asks.samples() * std::max(1, static_cast<int>(s.scene.lights.size())));
}

}  // namespace grader::check::direct_lights_inputs
