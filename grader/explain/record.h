#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/surface_point.h"
#include "pt/scene/recorder.h"
#include "pt/scene/scene.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

// The record of one call of a task: its questions, and the answers that it got.

namespace grader::explain {

using State = pt::Sampler::State;

// scene.closest was called.
struct TracedRay {
  pt::Ray ray;
  std::optional<pt::Hit> hit{};
};

// sample_light was called with a light of the scene, or with one that is not in its list (-1).
struct LightDraw {
  int light = -1;
  pt::Vec3 p;
  State before{}, after{};
  pt::LightSample sample{};
};

// diffuse_sample was called.
struct Direction {
  pt::Rgb albedo;
  pt::Vec3 wo;
  State before{}, after{};
  pt::BsdfSample sample{};
};

// direct_lights or direct_hemisphere was called. Its own calls are left out.
struct DirectLight {
  bool by_lights = false;
  pt::SurfacePoint point;
  int samples = 0;
  State before{}, after{};
  pt::Rgb light{};
};

using Event = std::variant<TracedRay, LightDraw, Direction, DirectLight>;

// One call: its result, its sampler, and what it asked, in order.
struct Told {
  pt::Rgb result;
  State before{}, after{};
  std::vector<Event> events;
};

// The events among the calls of pt/scene/recorder.h.
std::vector<Event> events_of(const pt::Scene& scene, std::span<const pt::Call> calls);

// Keeps the calls of this thread while it lives.
class Recording {
 public:
  Recording();
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  const std::vector<pt::Call>& calls() const { return calls_; }

 private:
  std::vector<pt::Call> calls_;
  std::vector<pt::Call>* outer_;
};

// Runs call i of a repetition, which gets Sampler::for_pixel(seed, i, 0), and keeps its record.
template <class Run>
Told record_one(const pt::Scene& scene, std::uint64_t seed, int i, const Run& run) {
  pt::Sampler sampler = pt::Sampler::for_pixel(seed, i, 0);
  Told told{{}, sampler.state(), {}, {}};
  const Recording recording;
  told.result = run(sampler);
  told.after = sampler.state();
  told.events = events_of(scene, recording.calls());
  return told;
}

// Computes what each event was told, from what it asked. A record of another process is then worth as much as one
// of this process: nothing in it is believed but the questions. Direct light needs the functions of its tasks;
// without them, and for a light or a sampler that nobody can check, the event is left as it is.
struct Answers {
  using Direct = pt::Rgb (*)(const pt::Scene&, const pt::SurfacePoint&, int, pt::Sampler&);
  Direct lights = nullptr, hemisphere = nullptr;
  pt::BsdfSample (*direction)(pt::Rgb, pt::Vec3, pt::Sampler&) = nullptr;
};
void answer(const pt::Scene& scene, const Answers& answers, std::vector<Event>& events);

// Returns how many numbers were drawn between two states of a sampler, or -1 if more than `most` or if one
// does not lead to the other.
int numbers_between(const State& from, const State& to, int most = 64);

}  // namespace grader::explain
