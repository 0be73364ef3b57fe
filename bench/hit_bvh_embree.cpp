#include "bench/render_tracing.h"
#include "pt/tasks/hit_bvh.h"

namespace pt {

RenderTracing render_tracing;

std::optional<Hit> hit_bvh(const Bvh&, const Primitives& primitives, const Ray& ray) {
  return render_tracing.embree->closest(primitives, ray);
}

bool occluded_bvh(const Bvh&, const Primitives&, const Ray& ray) {
  return render_tracing.embree->occluded(ray);
}

}  // namespace pt
