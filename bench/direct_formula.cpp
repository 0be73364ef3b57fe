#include "bench/direct_formula.h"

#include "grader/check/scenes/closed_forms.h"
#include "pt/geometry/spawn_ray.h"
#include "pt/geometry/surface_point.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <numbers>

namespace pt {
namespace {

// Points per pixel along each side. Inside a region, where the formula is smooth, few are enough.
constexpr int kSmooth = 4, kEdge = 64;
constexpr double kNearCorner = 0.49;  // distance from the centre, in sides

Vec3 at(const RectangleLight& light, double a, double b) {
  return light.center + a * light.u + b * light.v;
}

bool sees(const Scene& scene, const SurfacePoint& point, const RectangleLight& light) {
  constexpr double k = kNearCorner;
  const Vec3 seen[] = {light.center, at(light, -k, -k), at(light, -k, k), at(light, k, k),
                       at(light, k, -k)};
  return std::none_of(std::begin(seen), std::end(seen), [&](Vec3 q) {
    const double distance = length(q - point.p);
    const Vec3 wi = (q - point.p) / distance;
    return dot(wi, point.n) > 0 && scene.occluded(shadow_ray(point, wi, distance));
  });
}

// The luminance along a ray through x, y of the picture; nothing where the formula does not apply.
std::optional<double> luminance_at(const View& view, double x, double y) {
  const Ray ray = camera_ray(view.camera, x, y);
  const std::optional<Hit> hit = view.scene.closest(ray);
  if (!hit) return 0;
  const SurfacePoint point = surface_point(view.scene, ray, *hit);
  Rgb sum = point.emission;
  for (const Light& any : view.scene.lights) {
    const RectangleLight* const light = std::get_if<RectangleLight>(&any);
    if (light == nullptr) return std::nullopt;
    if (!(dot(point.p - light->center, light->n) > 0)) continue;  // its dark side
    if (!sees(view.scene, point, *light)) return std::nullopt;
    const std::vector<Vec3> corners{at(*light, -.5, -.5), at(*light, -.5, .5), at(*light, .5, .5),
                                    at(*light, .5, -.5)};
    const double cosine = grader::check::cosine_of_polygon(corners, point.p, point.n);
    sum += point.albedo * light->radiance * (cosine / std::numbers::pi);
  }
  return luminance(sum);
}

std::optional<double> luminance_of_pixel(const View& view, int pixel, int points) {
  const int x = pixel % view.width, y = view.height - 1 - pixel / view.width;
  double sum = 0;
  for (int i = 0; i < points * points; ++i) {
    const int column = i % points, row = i / points;
    const double dx = (column + 0.5) / points, dy = (row + 0.5) / points;
    const std::optional<double> one =
        luminance_at(view, (x + dx) / view.width, (y + dy) / view.height);
    if (!one) return std::nullopt;
    sum += *one;
  }
  return sum / (points * points);
}

}  // namespace

std::optional<std::vector<double>> direct_by_formula(const View& view,
                                                     const std::vector<Region>& regions) {
  if (view.settings.to != 1) return std::nullopt;
  std::vector<double> pixels(static_cast<std::size_t>(view.width) * view.height);
  // The last two regions are the pixels that show an edge, and all pixels.
  for (std::size_t i = 0; i + 1 < regions.size(); ++i) {
    const int points = i + 2 == regions.size() ? kEdge : kSmooth;
    for (const int pixel : regions[i].pixels) {
      const std::optional<double> one = luminance_of_pixel(view, pixel, points);
      if (!one) return std::nullopt;
      pixels[pixel] = *one;
    }
  }
  std::vector<double> means;
  for (const Region& region : regions) {
    double sum = 0;
    for (const int pixel : region.pixels) sum += pixels[pixel];
    means.push_back(sum / static_cast<double>(region.pixels.size()));
  }
  return means;
}

}  // namespace pt
