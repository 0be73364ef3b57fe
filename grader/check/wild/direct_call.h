#pragma once

#include "grader/check/language/repeat.h"
#include "grader/check/wild/scene_call.h"

#include <vector>

#include <fmt/format.h>

namespace grader::check {

// Calls direct_hemisphere or direct_lights with `count` samples, each of which costs about SamplesOfOne, and explains each call.
template <auto Task, auto Explain, int SamplesOfOne>
struct DirectCall {
  int count = 1;

  Explanations ask(const Situation& s, int n, std::uint64_t seed) const {
    Explanations all;
    for (explain::Told& told : repeat_recorded<Task>(n, seed, s.scene, s.point, count)) {
      explain::answer(s.scene, {}, told.events);
      all.push_back(Explain(s.scene, s.scene.tracer, s.point, count, told));
    }
    return all;
  }
  std::vector<DirectCall> smaller() const {
    std::vector<DirectCall> all;
    for (const int less : {1, count / 2, count - 1}) {
      if (less >= 1 && less < count) all.push_back({less});
    }
    return all;
  }
  std::string text() const { return fmt::format("samples: {}", count); }
  int samples() const { return SamplesOfOne * count; }
};

// Adds to `all` the explanations of some calls in a scene of the promises.
template <class Asks>
void add_usual_calls(Explanations& all, const rc::Gen<Situation>& generator, const Asks& asks,
                     int i, std::uint64_t seed) {
  constexpr int kCalls = 40;
  const Situation s = any_of(generator, seed + static_cast<std::uint64_t>(i));
  for (const auto& each : asks.ask(s, kCalls, seed)) all.push_back(each);
}

}  // namespace grader::check
