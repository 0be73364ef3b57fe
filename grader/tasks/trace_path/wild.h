#pragma once

#include "grader/check/language/repeat.h"
#include "grader/check/wild/scene_call.h"
#include "grader/tasks/trace_path/inputs.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <array>

// Calls of trace_path that are explained one by one.

namespace grader::check::trace_path_inputs {

struct Paths {
  PathSettings settings;

  Explanations ask(const pt::Scene& scene, const pt::SurfacePoint& point, int n,
                   std::uint64_t seed) const {
    constexpr explain::Answers kAnswers{&pt::direct_lights, &pt::direct_hemisphere,
                                        &pt::diffuse_sample};
    Explanations all;
    for (explain::Told& told : repeat_recorded<pt::trace_path>(n, seed, scene, point, settings)) {
      explain::answer(scene, kAnswers, told.events);
      all.push_back(explain::explain_path(scene, scene.tracer, point, settings, told));
    }
    return all;
  }
  Explanations ask(const Situation& s, int n, std::uint64_t seed) const {
    return ask(s.scene, s.point, n, seed);
  }
  std::vector<Paths> smaller() const {
    std::vector<Paths> all;
    const auto add = [&](auto PathSettings::*setting, auto value) {
      if (settings.*setting == value) return;
      all.push_back(*this);
      all.back().settings.*setting = value;
    };
    for (const int to : {2, 3, settings.to / 2, settings.to - 1}) {
      if (to < settings.to && to >= std::max(1, settings.from)) add(&PathSettings::to, to);
    }
    if (settings.from > 1) add(&PathSettings::from, settings.from - 1);
    add(&PathSettings::from, std::min(settings.from, 1));
    add(&PathSettings::light_samples, 1);
    if (settings.survival != 0.5 && settings.survival != 1) add(&PathSettings::survival, 0.5);
    return all;
  }
  std::string text() const {
    return fmt::format("bounces {} to {}; direct light by {}, samples {}; survival {:.4g}",
                       settings.from, settings.to,
                       settings.direct == Direct::lights ? "lights" : "hemisphere",
                       settings.light_samples, settings.survival);
  }
  int samples() const { return settings.light_samples * settings.to; }
};

inline Paths any_paths(RandomNumbers& random) {
  PathSettings s;
  s.to = std::array{
      1, 2, 2, 2, 3, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 8, 20, 100}[random.whole(0, 19)];
  s.from = by_chance(random, 0.3) ? s.to : random.whole(0, std::min(s.to, 3));
  s.survival = std::array{0.05, 0.3, 0.7, 1.0}[random.whole(0, 3)];
  if (s.to > 8) s.survival = by_chance(random, 0.7) ? 1 : 0.95;
  s.light_samples = std::array{1, 1, 1, 1, 2, 2, 3, 16}[random.whole(0, 7)];
  s.direct = by_chance(random, 0.5) ? Direct::lights : Direct::hemisphere;
  return {s};
}

inline Explanations usual_calls(std::uint64_t seed) {
  constexpr int kRooms = 40, kCallsOfRoom = 40;
  Explanations all;
  const auto add = [&](const rc::Gen<Room>& rooms, int i) {
    const Case c = any_of(asked_of(rooms, bounces(1, 5), real(0.3, 0.95)),
                          seed + static_cast<std::uint64_t>(i));
    const Paths paths{c.settings};
    for (const auto& each : paths.ask(c.room.scene, c.room.point, kCallsOfRoom, seed))
      all.push_back(each);
  };
  for (int i = 0; i < kRooms; i += 4) {
    add(round_room(gray(0.3, 0.8)), i);
    add(glowing_room(gray(0.3, 0.8)), i + 1);
    add(sunny_wall(gray(0.2, 1)), i + 2);
    add(room_around_a_lamp(gray(0.3, 0.8), either_way()), i + 3);
  }
  return all;
}

inline WildTask wild_task() {
  return {usual_calls, [](RandomNumbers& random) {
            const WildScene scene = wild_scene(random, true);
            return SceneCall<Paths>::make(scene, any_paths(random));
          }};
}

inline bool needs_no_mean(const pt::Scene& scene, const pt::SurfacePoint& point,
                          const PathSettings& settings, std::uint64_t seed) {
  const Paths asks{settings};
  return check::needs_no_mean(
      wild_task(), [&](int n) { return asks.ask(scene, point, n, seed); }, asks.samples());
}
inline bool needs_no_mean(const Case& c) {
  return needs_no_mean(c.room.scene, c.room.point, c.settings, c.seed);
}

}  // namespace grader::check::trace_path_inputs
