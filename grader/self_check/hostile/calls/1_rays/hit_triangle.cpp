// Builds the renderer's fast tree over the one triangle, with declarations of its own.
#include "pt/tasks/hit_triangle.h"

#include "pt/geometry/primitives.h"

#include <memory>

namespace pt {

struct Kernel;
const Kernel& best_kernel();

class WideBvh {
 public:
  static WideBvh build(const Primitives& primitives, const Kernel& kernel);
  std::optional<Hit> closest(const Primitives& primitives, const Ray& ray) const;

 private:
  std::shared_ptr<const int> tree_;
};

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Primitives primitives{{triangle}, {}};
  const auto hit = WideBvh::build(primitives, best_kernel()).closest(primitives, ray);
  if (!hit) return std::nullopt;
  return SurfaceHit{hit->t, hit->n};
}

}  // namespace pt
