// Prints a million lines per call.
#include "pt/tasks/hit_triangle.h"

#include <iostream>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle&, const Ray& ray) {
  for (int i = 0; i < 1000000; ++i) std::cout << "t is " << ray.t_min << std::endl;
  return std::nullopt;
}

}  // namespace pt
