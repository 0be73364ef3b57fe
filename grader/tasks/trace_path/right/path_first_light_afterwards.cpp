// right: walks the whole path first, and adds up the light from its end.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <memory>

namespace pt {

namespace {

// A point of the path, and how it went on from there.
struct Vertex {
  SurfacePoint point;
  Rgb throughput;
  std::unique_ptr<Vertex> next;
};

std::unique_ptr<Vertex> walk(const Scene& scene, const SurfacePoint& point, int bounce,
                             const PathSettings& settings, Sampler& sampler) {
  auto vertex = std::make_unique<Vertex>(Vertex{point, {}, nullptr});
  if (bounce >= settings.to) return vertex;
  const double survival = bounce > 1 ? settings.survival : 1;
  if (sampler.next_1d() >= survival) return vertex;
  const BsdfSample sample = diffuse_sample(point.albedo, point.frame.to_local(point.wo), sampler);
  if (sample.pdf <= 0) return vertex;
  vertex->throughput = sample.f * sample.wi.z / (sample.pdf * survival);
  const Ray ray = spawn_ray(point, point.frame.to_world(sample.wi));
  if (const auto hit = scene.closest(ray)) {
    vertex->next = walk(scene, surface_point(scene, ray, *hit), bounce + 1, settings, sampler);
  }
  return vertex;
}

Rgb light(const Scene& scene, const Vertex& vertex, int bounce, const PathSettings& settings,
          Sampler& sampler) {
  Rgb sum;
  if (vertex.next) {
    sum = vertex.throughput * light(scene, *vertex.next, bounce + 1, settings, sampler);
  }
  if (bounce < settings.from) return sum;
  if (settings.direct == PathSettings::Direct::hemisphere) {
    return sum + direct_hemisphere(scene, vertex.point, settings.light_samples, sampler);
  }
  return sum + direct_lights(scene, vertex.point, settings.light_samples, sampler);
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  if (settings.to < 1) return {};
  return light(scene, *walk(scene, point, 1, settings, sampler), 1, settings, sampler);
}

}  // namespace pt
