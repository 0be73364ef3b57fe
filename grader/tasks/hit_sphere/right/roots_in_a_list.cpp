// right: a local class, a std::function and a list of roots, sorted and searched
#include "pt/tasks/hit_sphere.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  struct Polynomial {
    double a, b, c;
    std::unique_ptr<std::vector<double>> roots() const {
      auto list = std::make_unique<std::vector<double>>();
      const double d = b * b - 4 * a * c;
      if (d < 0) return list;
      // The larger of the two without a difference, the other by Vieta.
      const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));
      if (q != 0) list->push_back(c / q);
      list->push_back(q / a);
      std::sort(list->begin(), list->end());
      return list;
    }
  };
  const Vec3 m = ray.origin - sphere.center;
  const double r = sphere.radius;
  const Polynomial distance{dot(ray.direction, ray.direction), 2 * dot(m, ray.direction),
                            dot(m, m) - r * r};
  const std::function<bool(double)> in_range = [&ray](double t) {
    return ray.t_min <= t && t <= ray.t_max;
  };
  const auto roots = distance.roots();
  const auto first = std::find_if(roots->begin(), roots->end(), in_range);
  if (first == roots->end()) return std::nullopt;
  return SurfaceHit{*first, normalize(ray.at(*first) - sphere.center)};
}

}  // namespace pt
