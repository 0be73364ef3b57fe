// right: a machine whose states are in a std::variant; one number, drawn first, says by its
// logarithm at which bounce roulette ends the path.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace pt {

namespace {

struct Arrives {
  SurfacePoint point;
};
struct Leaves {
  SurfacePoint point;
};
struct Flies {
  Ray ray;
};
struct Ends {};
using State = std::variant<Arrives, Leaves, Flies, Ends>;

struct Path {
  const Scene& scene;
  const PathSettings& settings;
  Sampler& sampler;
  int last;  // the path ends at this bounce
  int bounce = 1;
  Rgb sum{}, throughput = gray(1);

  State operator()(const Arrives& here) {
    if (bounce >= settings.from) {
      const auto direct =
          settings.direct == PathSettings::Direct::hemisphere ? direct_hemisphere : direct_lights;
      sum += throughput * direct(scene, here.point, settings.light_samples, sampler);
    }
    if (bounce == last) return Ends{};
    return Leaves{here.point};
  }
  State operator()(const Leaves& here) {
    const SurfacePoint& point = here.point;
    const auto [wi, f, pdf] = diffuse_sample(point.albedo, point.frame.to_local(point.wo), sampler);
    if (!(pdf > 0)) return Ends{};
    throughput *= f * (wi.z / pdf);
    if (bounce > 1) throughput /= settings.survival;
    return Flies{spawn_ray(point, point.frame.to_world(wi))};
  }
  State operator()(const Flies& now) {
    const std::optional<Hit> hit = scene.closest(now.ray);
    if (!hit) return Ends{};
    ++bounce;
    return Arrives{surface_point(scene, now.ray, *hit)};
  }
  State operator()(Ends) { return Ends{}; }
};

// Roulette lets a path go on n times more after its second point with the chance survival^n, and
// this is the chance that a number is at most survival^n.
int last_bounce(const PathSettings& settings, Sampler& sampler) {
  const double xi = sampler.next_1d();
  if (settings.survival >= 1) return settings.to;
  const double more = std::floor(std::log(xi) / std::log(settings.survival));
  return static_cast<int>(std::min<double>(settings.to, 2 + more));
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  if (settings.from > settings.to || settings.to < 1) return {};
  Path path{scene, settings, sampler, last_bounce(settings, sampler)};
  State state = Arrives{point};
  while (!std::holds_alternative<Ends>(state)) state = std::visit(path, state);
  return path.sum;
}

}  // namespace pt
