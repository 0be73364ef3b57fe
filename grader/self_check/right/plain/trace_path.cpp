#include "pt/tasks/trace_path.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"

#include <cmath>
namespace pt {
static Rgb bounce(const Scene& scene, const SurfacePoint& p, const PathSettings& s,
                  Sampler& sampler, int depth) {
  Rgb L;
  if (depth > s.to) return L;
  if (depth >= s.from)
    L = s.direct == PathSettings::Direct::hemisphere
            ? direct_hemisphere(scene, p, s.light_samples, sampler)
            : direct_lights(scene, p, s.light_samples, sampler);
  if (depth + 1 > s.to) return L;
  double prob = depth == 1 ? 1 : s.survival;
  if (sampler.next_1d() > prob) return L;
  BsdfSample b = diffuse_sample(p.albedo, p.frame.to_local(p.wo), sampler);
  if (b.pdf < 1e-300) return L;
  Ray ray = spawn_ray(p, p.frame.to_world(b.wi));
  auto hit = scene.closest(ray);
  if (!hit) return L;
  Rgb in = bounce(scene, surface_point(scene, ray, *hit), s, sampler, depth + 1);
  return L + b.f * in * (float)std::fabs(b.wi.z) / (b.pdf * prob);
}
Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  return bounce(scene, point, settings, sampler, 1);
}
}  // namespace pt
