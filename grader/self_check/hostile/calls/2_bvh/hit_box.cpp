// Reaches another task through a pointer, so that its name stands in no call.
#include "pt/tasks/hit_box.h"

#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

namespace {

std::optional<SurfaceHit> (*volatile test)(const Sphere&, const Ray&) = hit_sphere;

}  // namespace

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  Sphere around;
  around.center = box.center();
  around.radius = length(box.extent());
  const auto hit = test(around, ray);
  if (!hit) return std::nullopt;
  return Interval{hit->t, hit->t};
}

}  // namespace pt
