// Lets hit_triangle test many small triangles.
#include "pt/tasks/hit_sphere.h"

#include "pt/tasks/hit_triangle.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  std::optional<SurfaceHit> nearest;
  const auto at = [&](double theta, double phi) {
    return sphere.center + sphere.radius * Vec3{std::sin(theta) * std::cos(phi), std::cos(theta),
                                                std::sin(theta) * std::sin(phi)};
  };
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 20; ++j) {
      Triangle triangle;
      triangle.p0 = at(0.314 * i, 0.314 * j);
      triangle.p1 = at(0.314 * (i + 1), 0.314 * j);
      triangle.p2 = at(0.314 * i, 0.314 * (j + 1));
      const auto hit = hit_triangle(triangle, ray);
      if (hit && (!nearest || hit->t < nearest->t)) nearest = hit;
    }
  }
  return nearest;
}

}  // namespace pt
