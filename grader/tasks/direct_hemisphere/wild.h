#pragma once

#include "grader/check/language/repeat.h"
#include "grader/check/wild/scene_call.h"
#include "grader/tasks/direct_hemisphere/inputs.h"
#include "pt/tasks/direct_hemisphere.h"

#include <algorithm>

// Calls of direct_hemisphere that are explained one by one.

namespace grader::check::direct_hemisphere_inputs {

struct Hemisphere {
  int count = 1;

  Explanations ask(const Situation& s, int n, std::uint64_t seed) const {
    Explanations all;
    for (explain::Told& told :
         repeat_recorded<pt::direct_hemisphere>(n, seed, s.scene, s.point, count)) {
      explain::answer(s.scene, {}, told.events);
      all.push_back(explain::explain_hemisphere(s.scene, s.scene.tracer, s.point, count, told));
    }
    return all;
  }
  std::vector<Hemisphere> smaller() const {
    std::vector<Hemisphere> all;
    for (const int less : {1, count / 2, count - 1}) {
      if (less >= 1 && less < count) all.push_back({less});
    }
    return all;
  }
  std::string text() const { return fmt::format("samples: {}", count); }
  int samples() const { return count; }
};

// Few of them are long: a long call is as good as many short ones for most mistakes, and the others are limits.
inline int wild_samples(RandomNumbers& random) {
  const int kind = random.whole(1, 3000);
  if (kind == 1) return 65537;
  if (kind <= 5) return 5000;
  return std::array{1, 1, 1, 1, 2, 2, 3, 5, 8, 16, 16, 30, 100}[random.whole(0, 12)];
}

inline Explanations usual_calls(std::uint64_t seed) {
  constexpr int kScenes = 40, kCalls = 40;
  Explanations all;
  const auto add = [&](const rc::Gen<Situation>& generator, int i) {
    const Situation s = any_of(generator, seed + static_cast<std::uint64_t>(i));
    for (const auto& each : Hemisphere{1 + 5 * (i % 4)}.ask(s, kCalls, seed)) all.push_back(each);
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

}  // namespace grader::check::direct_hemisphere_inputs
