#include "bench/test_scenes.h"

#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
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

}  // namespace

TestScene blob_scene(int triangles) {
  TestScene result;
  result.name = "blob " + std::to_string(triangles);
  Scene& scene = result.scene;
  const int rows = std::max(3, static_cast<int>(std::sqrt(triangles / 4.0)));
  scene.primitives.triangles = blob(rows, 0.2);
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

}  // namespace pt
