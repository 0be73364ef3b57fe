#include "bench/regions.h"

#include "pt/tasks/camera_ray.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace pt {
namespace {

constexpr double kMinPart = 0.01;  // of the picture; smaller surfaces are not regions
constexpr double kUnits = 1e6;     // planes that differ by less than a millionth are the same

// The kind of surface at a point of the picture: a sphere, a plane, or anything else of a material.
struct Surface {
  int material = -1;  // -1: nothing
  int sphere = -1;
  std::array<long, 4> plane{};  // in units: normal, and distance from the origin
  bool flat = false;

  // clang-tidy 14 takes a 0 of the default for a pointer.
  auto operator<=>(const Surface&) const = default;  // NOLINT(modernize-use-nullptr)
};

Surface surface_of(const Scene& scene, const Hit& hit) {
  Surface surface;
  surface.material = scene.material_of[hit.primitive];
  const Primitives& all = scene.primitives;
  if (!all.is_triangle(hit.primitive)) {
    surface.sphere = hit.primitive - static_cast<int>(all.triangles.size());
    return surface;
  }
  const Triangle& triangle = all.triangle(hit.primitive);
  const Vec3 n = normalize(geometric_normal(triangle));
  surface.flat = dot(n, triangle.n0) > 1 - 1e-9 && dot(n, triangle.n1) > 1 - 1e-9;
  if (!surface.flat) return surface;
  const auto units = [](double x) { return std::lround(x * kUnits); };
  surface.plane = {units(n.x), units(n.y), units(n.z), units(dot(n, triangle.p0))};
  return surface;
}

// x and y are in pixels from the bottom left; the picture's corners are valid points.
Surface seen_at(const View& view, double x, double y) {
  const Ray ray = camera_ray(view.camera, x / view.width, y / view.height);
  const std::optional<Hit> hit = view.scene.closest(ray);
  return hit ? surface_of(view.scene, *hit) : Surface{};
}

// The surface that a pixel shows at its centre, its corners and the middles of its sides, if it is the same.
std::optional<Surface> only_surface(const View& view, int x, int y) {
  constexpr double kInside = 1e-6;  // the last column's right edge is not the next one's left
  const double at[] = {kInside, 0.5, 1 - kInside};
  const Surface first = seen_at(view, x + at[1], y + at[1]);
  for (const double dx : at) {
    for (const double dy : at) {
      if (seen_at(view, x + dx, y + dy) != first) return std::nullopt;
    }
  }
  return first;
}

std::string name_of(const Surface& surface, const Scene& scene) {
  if (surface.material < 0) return "nothing";
  const std::string& material = scene.materials[surface.material].name;
  if (surface.sphere >= 0) return fmt::format("{}, sphere {}", material, surface.sphere + 1);
  if (!surface.flat) return material + ", curved";
  const auto at = [&](int i) { return static_cast<double>(surface.plane[i]) / kUnits; };
  for (int i = 0; i < 3; ++i) {
    if (std::abs(at(i)) > 0.999999) {
      return fmt::format("{}, facing {}{}", material, at(i) > 0 ? '+' : '-', "xyz"[i]);
    }
  }
  return fmt::format("{}, facing ({:.2f} {:.2f} {:.2f})", material, at(0), at(1), at(2));
}

}  // namespace

std::vector<Region> find_regions(const View& view) {
  std::map<Surface, Region> found;
  Region edges{"edges", {}}, picture{"picture", {}};
  for (int i = 0; i < view.width * view.height; ++i) {
    const auto surface = only_surface(view, i % view.width, view.height - 1 - i / view.width);
    (surface ? found[*surface] : edges).pixels.push_back(i);
    picture.pixels.push_back(i);
  }
  std::vector<Region> regions;
  std::map<int, Region> small;  // by material
  for (auto& [surface, region] : found) {
    const auto size = static_cast<double>(region.pixels.size());
    if (size >= kMinPart * static_cast<double>(picture.pixels.size())) {
      regions.push_back({name_of(surface, view.scene), std::move(region.pixels)});
      continue;
    }
    std::vector<int>& rest = small[surface.material].pixels;
    rest.insert(rest.end(), region.pixels.begin(), region.pixels.end());
  }
  for (auto& [material, region] : small) {
    region.name = material < 0 ? "nothing" : view.scene.materials[material].name + ", small parts";
    regions.push_back(std::move(region));
  }
  regions.push_back(std::move(edges));
  regions.push_back(std::move(picture));
  return regions;
}

double mean_over(const Region& region, const Image& image) {
  double sum = 0;
  for (const int pixel : region.pixels) sum += luminance(image.pixels[pixel]);
  return sum / static_cast<double>(region.pixels.size());
}

}  // namespace pt
