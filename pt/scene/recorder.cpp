#include "pt/scene/recorder.h"

#include <utility>

namespace pt {

constinit thread_local Recorder recorder;

namespace {

// Bounce k + 1 is direct light where the path's k-th ray ended, whether the task calls for it before
// it goes on or when it comes back.
int bounce_at(const PathTape& tape, Vec3 p) {
  for (std::size_t k = tape.rays.size(); k > 0; --k) {
    const PathTape::TracedRay& traced = tape.rays[k - 1];
    if (traced.hit && traced.ray.at(traced.hit->t) == p) return static_cast<int>(k) + 1;
  }
  return tape.start == p ? 1 : 0;
}

Rgb played(PathTape& tape, Sampler& sampler) {
  if (tape.next_light == tape.lights.size()) return {};
  const PathTape::DirectLight& direct = tape.lights[tape.next_light++];
  sampler = Sampler(direct.after);
  const bool wanted = tape.only.from <= direct.bounce && direct.bounce <= tape.only.to;
  return wanted ? direct.light : Rgb{};
}

}  // namespace

Rgb record_call(std::string_view name, DirectTask* task, const Scene& scene,
                const SurfacePoint& point, int samples, Sampler& sampler) {
  const auto run = [&] {
    return keep_call(
        name, [&] { return task(scene, point, samples, sampler); }, scene, point, samples, sampler);
  };
  if (recorder.path == nullptr) return run();
  if (recorder.path->mode == PathTape::Mode::play) return played(*recorder.path, sampler);
  // Its own rays do not belong to the path.
  PathTape& tape = *std::exchange(recorder.path, nullptr);
  const Rgb light = run();
  recorder.path = &tape;
  tape.lights.push_back({bounce_at(tape, point.p), light, sampler.state()});
  return light;
}

}  // namespace pt
