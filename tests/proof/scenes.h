#pragma once

#include "pt/math/frame.h"
#include "pt/scene/scene.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

// Scenes built in code, so that every number in them is known.

namespace pt::proof {

inline constexpr Engine kEngines[] = {Engine::linear, Engine::task};

// A rigid motion: local coordinates to world space.
struct Place {
  Frame frame;
  Vec3 origin;

  Vec3 point(Vec3 local) const { return origin + frame.to_world(local); }
  Vec3 direction(Vec3 local) const { return frame.to_world(local); }
};

// A tilted place: no axis of the world is an axis of the scene.
inline Place askew() { return {frame_from_normal(normalize({0.3, -0.5, 0.4})), {0.7, -1.3, 2.1}}; }

class SceneBuilder {
 public:
  int material(Rgb albedo, Rgb emission = {}) {
    scene_.materials.push_back({"", albedo, emission, ""});
    return static_cast<int>(scene_.materials.size()) - 1;
  }

  // If its material emits, it emits to the side where the corners run anticlockwise.
  void triangle(Vec3 a, Vec3 b, Vec3 c, int material) {
    scene_.primitives.triangles.push_back(flat_triangle(a, b, c));
    of_triangles_.push_back(material);
  }

  // The parallelogram from `corner` along u and v; its front is the side of cross(u, v).
  void quad(Vec3 corner, Vec3 u, Vec3 v, int material) {
    triangle(corner, corner + u, corner + u + v, material);
    triangle(corner, corner + u + v, corner + v, material);
  }

  void sphere(Vec3 center, double radius, int material) {
    scene_.primitives.spheres.push_back({center, radius});
    of_spheres_.push_back(material);
  }

  // A closed room, its twelve triangles facing inwards.
  void room(Vec3 min, Vec3 max, int material) {
    const Vec3 x{max.x - min.x, 0, 0}, y{0, max.y - min.y, 0}, z{0, 0, max.z - min.z};
    quad(min, y, z, material);
    quad(min, z, x, material);
    quad(min, x, y, material);
    quad(max, -z, -y, material);
    quad(max, -x, -z, material);
    quad(max, -y, -x, material);
  }

  void light(const Light& light) { scene_.lights.push_back(light); }

  const std::vector<Triangle>& triangles() const { return scene_.primitives.triangles; }

  Scene finish(Engine engine) const {
    Scene scene = scene_;
    scene.material_of = of_triangles_;
    scene.material_of.insert(scene.material_of.end(), of_spheres_.begin(), of_spheres_.end());
    scene.tracer = Tracer(engine, scene.primitives);
    return scene;
  }

 private:
  Scene scene_;
  std::vector<int> of_triangles_;
  std::vector<int> of_spheres_;
};

// The point that is visible from `eye` in the direction of `target`.
inline SurfacePoint point_seen(const Scene& scene, Vec3 eye, Vec3 target) {
  const Ray ray{eye, normalize(target - eye), 0, kInfinity};
  const std::optional<Hit> hit = scene.closest(ray);
  if (!hit) throw std::logic_error("the test looks past its own scene");
  return surface_point(scene, ray, *hit);
}

inline MeshLight mesh_light(const std::vector<Triangle>& triangles, Rgb radiance) {
  std::vector<MeshLight::Face> faces;
  for (const Triangle& t : triangles) faces.push_back({t.p0, t.p1, t.p2});
  return make_mesh_light(faces, radiance);
}

inline std::string in_words(const Scene& scene) {
  return "engine " + std::string(name(scene.tracer.engine()));
}

}  // namespace pt::proof
