#include "pt/scene/export/parts.h"

#include "pt/error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pt {
namespace {

// The tolerance for the power of the lights, compared with that of the surfaces that emit.
constexpr double kSamePower = 1e-6;
// A triangle counts as flat if the normals of its corners are closer to the face's than this.
constexpr double kFlat = 1e-9;

bool is_flat(const Triangle& triangle) {
  const Vec3 n = normalize(geometric_normal(triangle));
  return std::min({dot(n, triangle.n0), dot(n, triangle.n1), dot(n, triangle.n2)}) > 1 - kFlat;
}

double sphere_area(double radius) { return 4 * kPi * radius * radius; }

// Area times luminance: the power without its factor pi.
double power_of_surfaces(const Scene& scene) {
  double power = 0;
  const Primitives& all = scene.primitives;
  for (int i = 0; i < all.size(); ++i) {
    const double area = all.is_triangle(i) ? 0.5 * length(geometric_normal(all.triangle(i)))
                                           : sphere_area(all.sphere(i).radius);
    power += area * luminance(material(scene, i).emission);
  }
  return power;
}

double power_of_lights(const Scene& scene) {
  double power = 0;
  for (const Light& light : scene.lights) {
    if (const auto* rectangle = std::get_if<RectangleLight>(&light)) {
      power += length(cross(rectangle->u, rectangle->v)) * luminance(rectangle->radiance);
    } else if (const auto* sphere = std::get_if<SphereLight>(&light)) {
      power += sphere_area(sphere->radius) * luminance(sphere->radiance);
    } else if (const auto* mesh = std::get_if<MeshLight>(&light)) {
      power += mesh->area_up_to.back() * luminance(mesh->radiance);
    }
  }
  return power;
}

}  // namespace

std::vector<TriangleGroup> triangle_groups(const Scene& scene) {
  std::map<std::pair<int, bool>, TriangleGroup> groups;
  for (std::size_t i = 0; i < scene.primitives.triangles.size(); ++i) {
    const Triangle& triangle = scene.primitives.triangles[i];
    const bool flat = is_flat(triangle);
    TriangleGroup& group = groups[{scene.material_of[i], flat}];
    group.material = scene.material_of[i];
    group.flat = flat;
    group.triangles.push_back(triangle);
  }
  std::vector<TriangleGroup> all;
  for (auto& [key, group] : groups) all.push_back(std::move(group));
  return all;
}

void require_surfaces(const Scene& scene, const std::string& name) {
  for (const Material& material : scene.materials) {
    if (material.behind < 0) continue;
    throw Error(name + ": surfaces of '" + material.name +
                "' have another material on their back; another renderer would show them "
                "differently");
  }
  const double power = power_of_surfaces(scene);
  if (std::abs(power_of_lights(scene) - power) > kSamePower * power) {
    throw Error(name +
                ": an area light has no surface that emits; another renderer would show it "
                "differently");
  }
}

}  // namespace pt
