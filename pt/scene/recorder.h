#pragma once

#include "pt/geometry/hit.h"
#include "pt/scene/bounce_range.h"
#include "pt/scene/scene.h"

#include <any>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace pt {

// Numbers of boxes and primitives that were tested.
struct TestCount {
  long long boxes = 0;
  long long triangles = 0;
  long long spheres = 0;
};

// The boxes and primitives themselves, in the order in which they were tested.
struct Tested {
  std::vector<Box> boxes;
  std::vector<Triangle> triangles;
  std::vector<Sphere> spheres;
};

// The walk of one path: the answers of scene.closest and of the tasks that estimate direct light, in order. The same path
// can then be walked again without tracing a ray, with the direct light of some bounces only (pt/render/bounces_apart.h).
struct PathTape {
  enum class Mode { record, play };
  struct TracedRay {
    Ray ray;
    std::optional<Hit> hit;
  };
  struct DirectLight {
    int bounce = 0;  // 0: of a point that is not on the path
    Rgb light;
    Sampler::State after;  // the task has drawn its numbers
  };

  Mode mode = Mode::record;
  Vec3 start;              // of the path
  BounceRange only;        // the bounces that are not black while the tape is played
  std::size_t enough = 0;  // lights: when so many were played, no ray hits any more
  std::vector<TracedRay> rays;
  std::vector<DirectLight> lights;
  std::size_t next_ray = 0, next_light = 0;  // to be played
};

// One call of a function: a task, or closest, occluded or sample_light, which tasks call.
struct Call {
  std::string_view name;
  std::any in;                       // std::tuple of the arguments, see kept(); without a sampler
  std::any out;                      // the result
  Sampler::State before{}, after{};  // of the sampler among the arguments
  std::size_t end = 0;               // the calls from the next one up to this index were made by it
};

// The record of this thread's calls of tasks. It is kept in programs that link tasks in their recorded form
// (cmake/recorded.cpp.in): tests are always counted; they are listed, paths are taped, and whole calls are kept while a
// pointer says where (tests are too many to be kept as calls). In programs that link the plain form all of it stays empty, and costs nothing.
struct Recorder {
  TestCount count;
  Tested* tested = nullptr;
  PathTape* path = nullptr;
  std::vector<Call>* calls = nullptr;
};

extern constinit thread_local Recorder recorder;

// An argument as a call keeps it: a copy; of a scene only where it is.
template <class T>
std::tuple<T> kept(const T& value) {
  return {value};
}
inline std::tuple<const Scene*> kept(const Scene& scene) { return {&scene}; }
inline std::tuple<> kept(const Sampler&) { return {}; }

template <class T>
const Sampler* sampler_in(const T&) {
  return nullptr;
}
inline const Sampler* sampler_in(const Sampler& sampler) { return &sampler; }

template <class... Arguments>
Sampler::State state_in(const Arguments&... arguments) {
  const Sampler* found = nullptr;
  ((found = sampler_in(arguments) ? sampler_in(arguments) : found), ...);
  return found ? found->state() : Sampler::State{};
}

// Runs the call, and keeps it if calls are kept.
template <class Run, class... Arguments>
auto keep_call(std::string_view name, const Run& run, const Arguments&... arguments) {
  if (recorder.calls == nullptr) return run();
  std::vector<Call>& calls = *recorder.calls;
  const std::size_t place = calls.size();
  calls.push_back({name, std::any(std::tuple_cat(kept(arguments)...)), {}, state_in(arguments...)});
  auto result = run();
  Call& call = calls[place];
  call.out = result;
  call.after = state_in(arguments...);
  call.end = calls.size();
  return result;
}

inline void record_test(const Box& box) {
  ++recorder.count.boxes;
  if (recorder.tested != nullptr) recorder.tested->boxes.push_back(box);
}

inline void record_test(const Triangle& triangle) {
  ++recorder.count.triangles;
  if (recorder.tested != nullptr) recorder.tested->triangles.push_back(triangle);
}

inline void record_test(const Sphere& sphere) {
  ++recorder.count.spheres;
  if (recorder.tested != nullptr) recorder.tested->spheres.push_back(sphere);
}

// Calls of a task in its recorded form go through the function here that has the task's signature.
using DirectTask = Rgb(const Scene&, const SurfacePoint&, int, Sampler&);
Rgb record_call(std::string_view name, DirectTask* task, const Scene& scene,
                const SurfacePoint& point, int samples, Sampler& sampler);

template <class Result, class Shape>
Result record_call(std::string_view, Result (*task)(const Shape&, const Ray&), const Shape& shape,
                   const Ray& ray) {
  record_test(shape);
  return task(shape, ray);
}

template <class Result, class... Parameters, class... Arguments>
Result record_call(std::string_view name, Result (*task)(Parameters...), Arguments&... arguments) {
  return keep_call(
      name, [&] { return task(arguments...); }, arguments...);
}

}  // namespace pt
