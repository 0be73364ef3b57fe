#pragma once

#include "pt/accel/wide_bvh.h"
#include "pt/geometry/bvh.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/ray.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace pt {

// The way in which a scene finds what a ray meets: testing every primitive in turn, the linked
// tasks of part 2, or the fast engine of pt/accel.
enum class Engine { linear, task, wide };

std::string_view name(Engine engine);

// The acceleration structure of a scene's primitives. It does not own them: every query gets the
// same Primitives that it was built for. Queries are const and safe from any thread.
//
// All engines give the same answers: the closest hit with t in the ray's range; if several have the
// same t, the primitive with the smallest index (task: the choice of the linked hit_bvh). Surfaces whose
// t differ by rounding alone may be met in another order by each engine; the loader makes one surface of
// triangles with the same corners, so that its scenes have none that lie exactly on another.
class Tracer {
 public:
  Tracer() = default;  // traces linearly
  Tracer(Engine engine, const Primitives& primitives, int max_leaf = 4);

  std::optional<Hit> closest(const Primitives& primitives, const Ray& ray) const;
  bool occluded(const Primitives& primitives, const Ray& ray) const;

  // Takes up to 32 rays, best from one point. Bit i says whether anything lies in ray i's range.
  std::uint32_t occluded(const Primitives& primitives, std::span<const Ray> rays) const;

  Engine engine() const { return engine_; }
  const Bvh& bvh() const { return bvh_; }  // empty unless Engine::task

 private:
  Engine engine_ = Engine::linear;
  Bvh bvh_;
  WideBvh wide_;
};

}  // namespace pt
