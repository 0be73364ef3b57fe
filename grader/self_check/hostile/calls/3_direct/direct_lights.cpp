// Hands the work on to trace_path.
#include "pt/tasks/direct_lights.h"

namespace pt {

struct PathSettings {
  int light_samples;
  enum class Direct { hemisphere, lights } direct;
  double survival;
  int from, to;
  bool show_normals;
};
Rgb trace_path(const Scene&, const SurfacePoint&, const PathSettings&, Sampler&);

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  return trace_path(scene, point, {samples, PathSettings::Direct::hemisphere, 1, 1, 1, false},
                    sampler);
}

}  // namespace pt
