#include "bench/test_scenes.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "pt/tasks/camera_ray.h"
#include "tests/pt/accel/generated_meshes.h"

#include <filesystem>

namespace pt {

namespace {

void add_quad(Scene& scene, Vec3 corner, Vec3 u, Vec3 v, int material) {
  const Vec3 far = corner + u + v;
  for (const Triangle& t :
       {flat_triangle(corner, corner + u, far), flat_triangle(corner, far, corner + v)}) {
    scene.primitives.triangles.push_back(t);
    scene.material_of.push_back(material);
  }
}

// The box is [-1.6, 1.6]^3, open towards +z, where the camera is.
void add_box(Scene& scene) {
  const double a = 1.6, b = 2 * a;
  add_quad(scene, {-a, -a, a}, {b, 0, 0}, {0, 0, -b}, 0);
  add_quad(scene, {-a, a, -a}, {b, 0, 0}, {0, 0, b}, 0);
  add_quad(scene, {-a, -a, -a}, {b, 0, 0}, {0, b, 0}, 0);
  add_quad(scene, {-a, -a, a}, {0, 0, -b}, {0, b, 0}, 1);
  add_quad(scene, {a, -a, -a}, {0, 0, b}, {0, b, 0}, 2);
}

constexpr int kWidth = 480;
constexpr int kHeight = 360;

// Adds rays towards random lights, if light from them arrives.
void add_shadow_rays(const Scene& scene, const SurfacePoint& point, Sampler& sampler,
                     std::vector<Ray>& rays) {
  if (scene.lights.empty()) return;
  std::vector<Ray> group;
  for (int attempt = 0; attempt < 4 * kShadowGroup; ++attempt) {
    const auto which =
        static_cast<std::size_t>(sampler.next_1d() * static_cast<double>(scene.lights.size()));
    const LightSample sample = sample_light(scene.lights[which], point.p, sampler);
    if (!(dot(sample.wi, point.n) > 0) || is_black(sample.radiance)) continue;
    group.push_back(shadow_ray(point, sample.wi, sample.distance));
    if (group.size() == kShadowGroup) {
      rays.insert(rays.end(), group.begin(), group.end());
      return;
    }
  }
}

// The triangles in the box, under its light.
TestScene in_a_box(const std::string& name, std::vector<Triangle> triangles) {
  TestScene result;
  result.name = name;
  Scene& scene = result.scene;
  scene.primitives.triangles = std::move(triangles);
  scene.material_of.assign(scene.primitives.triangles.size(), 0);
  scene.materials = {{"white", {.7, .7, .7}, {}, {}},
                     {"red", {.6, .1, .1}, {}, {}},
                     {"green", {.1, .6, .1}, {}, {}},
                     {"lamp", {}, {10, 10, 10}, {}}};
  add_box(scene);
  const Vec3 corner{-.4, 1.599, -.4}, u{.8, 0, 0}, v{0, 0, .8};
  add_quad(scene, corner, u, v, 3);
  scene.lights.push_back(
      RectangleLight{corner + 0.5 * u + 0.5 * v, u, v, {0, -1, 0}, {10, 10, 10}});
  result.camera = {{0, 0, 5.5}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 45, 34.5, 0, kInfinity};
  return result;
}

}  // namespace

TestScene blob_scene(int triangles) {
  const int rows = std::max(3, static_cast<int>(std::sqrt(triangles / 4.0)));
  return in_a_box("blob " + std::to_string(triangles), blob(rows, 0.2));
}

TestScene needles_scene(int triangles) {
  Sampler sampler(2);
  const auto number = [&] { return 2 * sampler.next_1d() - 1; };
  std::vector<Triangle> needles;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 at{number(), number(), number()};
    const Vec3 along = 0.4 * uniform_hemisphere(sampler.next_2d());
    const Vec3 across = 0.004 * uniform_hemisphere(sampler.next_2d());
    needles.push_back(flat_triangle(at - along, at + along, at + along + across));
  }
  return in_a_box("needles " + std::to_string(triangles), std::move(needles));
}

TestScene file_scene(const std::string& file, int width, int height) {
  LoadOptions options;
  options.lambertian = true;
  LoadedScene loaded = load_collada(file, options);
  TestScene result;
  result.name = std::filesystem::path(file).stem().string();
  result.camera = frame_camera(loaded, Framing::course, width, height);
  result.scene = std::move(loaded.scene);
  return result;
}

RaySets make_rays(const TestScene& test, int count) {
  RaySets sets;
  Sampler sampler(1);
  const Scene& scene = test.scene;
  const int pixels = kWidth * kHeight;
  const auto wanted = static_cast<std::size_t>(count);
  const auto full = [&](const std::vector<Ray>& rays) { return rays.size() >= wanted; };
  for (int i = 0; i < 64 * count && !(full(sets.primary) && full(sets.bounce)); ++i) {
    const int pixel = static_cast<int>(static_cast<long long>(i) * pixels / count) % pixels;
    const Vec2 xi = sampler.next_2d();
    const int x = pixel % kWidth, y = pixel / kWidth;
    Ray ray = camera_ray(test.camera, (x + xi.x) / kWidth, (y + xi.y) / kHeight);
    if (!full(sets.primary)) sets.primary.push_back(ray);
    for (int bounce = 0; bounce < 2; ++bounce) {
      const std::optional<Hit> hit = scene.closest(ray);
      if (!hit) break;
      const SurfacePoint point = surface_point(scene, ray, *hit);
      if (i % 8 == 0 && !full(sets.shadow)) add_shadow_rays(scene, point, sampler, sets.shadow);
      ray = spawn_ray(point, point.frame.to_world(cosine_hemisphere(sampler.next_2d())));
      if (!full(sets.bounce)) sets.bounce.push_back(ray);
    }
  }
  return sets;
}

}  // namespace pt
