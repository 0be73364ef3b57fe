#pragma once

#include "pt/geometry/hit.h"
#include "pt/scene/bounce_range.h"
#include "pt/scene/scene.h"

#include <optional>
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
  Vec3 start;        // of the path
  BounceRange only;  // the bounces that are not black while the tape is played
  std::vector<TracedRay> rays;
  std::vector<DirectLight> lights;
  std::size_t next_ray = 0, next_light = 0;  // to be played
};

// The record of this thread's calls of tasks. It is kept in programs that link tasks in their recorded form
// (cmake/recorded.cpp.in): tests are always counted; they are listed and paths are taped while a pointer says where. In
// programs that link the plain form all of it stays empty, and costs nothing.
struct Recorder {
  TestCount count;
  Tested* tested = nullptr;
  PathTape* path = nullptr;
};

extern constinit thread_local Recorder recorder;

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
Rgb record_call(DirectTask* task, const Scene& scene, const SurfacePoint& point, int samples,
                Sampler& sampler);

template <class Result, class Shape>
Result record_call(Result (*task)(const Shape&, const Ray&), const Shape& shape, const Ray& ray) {
  record_test(shape);
  return task(shape, ray);
}

}  // namespace pt
