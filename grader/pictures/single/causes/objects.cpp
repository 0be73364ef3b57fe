#include "grader/pictures/single/causes/suspects.h"
#include "pt/render/choose_engine.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

// Primitives that a program can lose together.
struct Object {
  std::string words;
  std::function<bool(int primitive)> holds;
};

std::vector<Object> objects_of(const pt::Scene& scene, const std::vector<int>& seen) {
  const pt::Primitives& primitives = scene.primitives;
  std::vector<Object> objects{
      {"every sphere", [&primitives](int i) { return !primitives.is_triangle(i); }},
      {"every triangle", [&primitives](int i) { return primitives.is_triangle(i); }}};
  std::set<int> materials, spheres;
  for (const int primitive : seen) {
    if (primitive < 0) continue;
    materials.insert(scene.material_of[primitive]);
    if (!primitives.is_triangle(primitive)) spheres.insert(primitive);
  }
  for (const int sphere : spheres) {
    const pt::Vec3 p = primitives.sphere(sphere).center;
    objects.push_back({fmt::format("the sphere around {:.3g} {:.3g} {:.3g}", p.x, p.y, p.z),
                       [=](int i) { return i == sphere; }});
  }
  for (const int material : materials) {
    objects.push_back({fmt::format("all that has the material {}", scene.materials[material].name),
                       [&scene, material](int i) { return scene.material_of[i] == material; }});
  }
  return objects;
}

// The first primitive that the centre of each pixel sees; -1 where there is none.
std::vector<int> primitives_seen(const pt::View& view) {
  std::vector<int> seen;
  for (int row = 0; row < view.height; ++row) {
    const double y = (view.height - 1 - row + 0.5) / view.height;
    for (int x = 0; x < view.width; ++x) {
      const auto hit = view.scene.closest(camera_ray(view.camera, (x + 0.5) / view.width, y));
      seen.push_back(hit ? hit->primitive : -1);
    }
  }
  return seen;
}

// The part of an object's pixels that are a quarter off, less that of all other pixels; 0 if it has less than a 200th of the picture, or all of it.
double evidence_against(const Object& object, const std::vector<int>& seen,
                        const SingleVerdict& verdict) {
  std::array<double, 2> off{}, all{};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const int inside = seen[i] >= 0 && object.holds(seen[i]) ? 1 : 0;
    const double ours = luminance(verdict.ours.pixels[i]);
    const double theirs = luminance(verdict.theirs.pixels[i]);
    all[inside] += 1;
    off[inside] += std::abs(theirs - ours) > 0.25 * ours + 0.01 ? 1 : 0;
  }
  if (all[0] == 0 || all[1] * 200 < static_cast<double>(seen.size())) return 0;
  return off[1] / all[1] - off[0] / all[0];
}

pt::Scene without(const pt::Scene& scene, const Object& object) {
  pt::Scene out;
  out.materials = scene.materials;
  out.lights = scene.lights;
  for (int i = 0; i < scene.primitives.size(); ++i) {
    if (object.holds(i)) continue;
    if (scene.primitives.is_triangle(i)) {
      out.primitives.triangles.push_back(scene.primitives.triangle(i));
    } else {
      out.primitives.spheres.push_back(scene.primitives.sphere(i));
    }
    out.material_of.push_back(scene.material_of[i]);
  }
  pt::choose_engine(out, scene.tracer.engine(), 4);
  return out;
}

pt::Scene with_black(const pt::Scene& scene, const Object& object) {
  pt::Scene out = scene;
  out.materials.push_back({"black", {}, {}, ""});
  for (int i = 0; i < scene.primitives.size(); ++i) {
    if (object.holds(i)) out.material_of[i] = static_cast<int>(out.materials.size()) - 1;
  }
  return out;
}

}  // namespace

void suspect_objects(Suspects& suspects, const SingleVerdict& verdict) {
  const pt::View& view = suspects.question().view;
  const std::vector<int> seen = primitives_seen(view);
  constexpr double kEnough = 0.3;
  constexpr std::size_t kTried = 4;
  std::vector<std::pair<double, Object>> likely;
  for (const Object& object : objects_of(view.scene, seen)) {
    const double evidence = evidence_against(object, seen, verdict);
    if (evidence > kEnough) likely.emplace_back(evidence, object);
  }
  std::ranges::stable_sort(likely, std::greater{}, &std::pair<double, Object>::first);
  likely.resize(std::min(likely.size(), kTried));
  for (const auto& [evidence, object] : likely) {
    const pt::Scene missing = without(view.scene, object), black = with_black(view.scene, object);
    const auto render = [&](const pt::Scene& scene) {
      return suspects.render({scene, view.camera, view.settings, view.width, view.height});
    };
    suspects.try_ours(object.words + " is missing", render(missing));
    suspects.try_ours(object.words + " is black", render(black));
  }
}

}  // namespace grader::pictures
