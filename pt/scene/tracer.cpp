#include "pt/scene/tracer.h"

#include "pt/tasks/build_bvh.h"
#include "pt/tasks/hit_bvh.h"

#include <cassert>

namespace pt {

namespace {

std::optional<Hit> closest_linear(const Primitives& primitives, Ray ray) {
  std::optional<Hit> closest;
  for (int i = 0; i < primitives.size(); ++i) {
    const std::optional<SurfaceHit> hit = hit_primitive(primitives, i, ray);
    if (!hit || (closest && !(hit->t < closest->t))) continue;
    closest = {hit->t, hit->n, i};
    ray.t_max = hit->t;
  }
  return closest;
}

bool occluded_linear(const Primitives& primitives, const Ray& ray) {
  for (int i = 0; i < primitives.size(); ++i) {
    if (hit_primitive(primitives, i, ray)) return true;
  }
  return false;
}

}  // namespace

std::string_view name(Engine engine) {
  switch (engine) {
    case Engine::linear:
      return "linear";
    case Engine::task:
      return "task";
    case Engine::wide:
      return "wide";
  }
  return "";
}

Tracer::Tracer(Engine engine, const Primitives& primitives, int max_leaf) : engine_(engine) {
  if (engine == Engine::wide) wide_ = WideBvh::build(primitives);
  if (engine != Engine::task) return;
  std::vector<Box> boxes;
  boxes.reserve(primitives.size());
  for (int i = 0; i < primitives.size(); ++i) boxes.push_back(bounds(primitives, i));
  bvh_ = build_bvh(boxes, max_leaf);
}

std::optional<Hit> Tracer::closest(const Primitives& primitives, const Ray& ray) const {
  if (engine_ == Engine::wide) return wide_.closest(primitives, ray);
  if (engine_ == Engine::linear) return closest_linear(primitives, ray);
  return hit_bvh(bvh_, primitives, ray);
}

bool Tracer::occluded(const Primitives& primitives, const Ray& ray) const {
  if (engine_ == Engine::wide) return wide_.occluded(primitives, ray);
  if (engine_ == Engine::linear) return occluded_linear(primitives, ray);
  return occluded_bvh(bvh_, primitives, ray);
}

std::uint32_t Tracer::occluded(const Primitives& primitives, std::span<const Ray> rays) const {
  assert(rays.size() <= 32);
  if (engine_ == Engine::wide) return wide_.occluded(primitives, rays);
  std::uint32_t blocked = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (occluded(primitives, rays[i])) blocked |= std::uint32_t{1} << i;
  }
  return blocked;
}

}  // namespace pt
