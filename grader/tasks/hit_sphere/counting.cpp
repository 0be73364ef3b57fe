#include "grader/check/mocks/counting.h"

#include "pt/accel/exact_hit.h"
#include "pt/tasks/hit_sphere.h"

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& about) {
  grader::check::count(sphere);
  const Ray ray = grader::check::asked(about);
  const ExactHit found = exact_hit(sphere, ray);
  if (!found.hit) return std::nullopt;
  return SurfaceHit{found.t, normalize(ray.at(found.t) - sphere.center)};
}

}  // namespace pt
