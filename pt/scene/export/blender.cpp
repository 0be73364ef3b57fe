#include "pt/scene/export/parts.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace pt {
namespace {

using Json = nlohmann::json;

Json numbers(Vec3 v) { return {v.x, v.y, v.z}; }
Json numbers(Rgb c) { return {c.r, c.g, c.b}; }

void append(Json& list, Vec3 v) {
  list.push_back(v.x);
  list.push_back(v.y);
  list.push_back(v.z);
}

Json triangle_list(const Scene& scene) {
  Json all = Json::array();
  for (const TriangleGroup& group : triangle_groups(scene)) {
    Json one{{"material", group.material}};
    for (const Triangle& t : group.triangles) {
      for (const Vec3 p : {t.p0, t.p1, t.p2}) append(one["corners"], p);
      if (group.flat) continue;
      for (const Vec3 n : {t.n0, t.n1, t.n2}) append(one["normals"], n);
    }
    all.push_back(std::move(one));
  }
  return all;
}

Json sphere_list(const Scene& scene) {
  Json all = Json::array();
  const int triangles = static_cast<int>(scene.primitives.triangles.size());
  for (int i = triangles; i < scene.primitives.size(); ++i) {
    const Sphere& sphere = scene.primitives.sphere(i);
    all.push_back({{"center", numbers(sphere.center)},
                   {"radius", sphere.radius},
                   {"material", scene.material_of[i]}});
  }
  return all;
}

Json material_list(const Scene& scene) {
  Json all = Json::array();
  for (const Material& material : scene.materials) {
    all.push_back({{"name", material.name},
                   {"albedo", numbers(material.albedo)},
                   {"emission", numbers(material.emission)}});
  }
  return all;
}

Json lamp_list(const Scene& scene) {
  Json all = Json::array();
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
      all.push_back({{"kind", "point"},
                     {"position", numbers(point->position)},
                     {"intensity", numbers(point->intensity)}});
    } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
      all.push_back({{"kind", "directional"},
                     {"direction", numbers(sun->direction)},
                     {"irradiance", numbers(sun->irradiance)}});
    }
  }
  return all;
}

Json camera_of(const Camera& camera) {
  const Frame& frame = camera.camera_to_world;
  return {{"position", numbers(camera.position)},
          {"frame", {numbers(frame.x), numbers(frame.y), numbers(frame.z)}},
          {"hfov", camera.hfov_deg * (kPi / 180)},
          {"near", camera.near_clip},
          {"far", std::min(camera.far_clip, 1e30)}};
}

}  // namespace

std::string to_blender(const ExportedView& view) {
  return Json{{"width", view.width},
              {"height", view.height},
              {"bounces", view.depth},
              {"materials", material_list(view.scene)},
              {"triangles", triangle_list(view.scene)},
              {"spheres", sphere_list(view.scene)},
              {"lamps", lamp_list(view.scene)},
              {"camera", camera_of(view.camera)}}
      .dump();
}

}  // namespace pt
