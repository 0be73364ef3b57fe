#include "site/live/room.h"

#include <cmath>

namespace site::live {

namespace {

using pt::Vec3;

void add_rectangle(pt::Scene& scene, const std::array<Vec3, 4>& corners, int material) {
  for (const auto& [b, c] : {std::pair{1, 2}, std::pair{2, 3}}) {
    scene.primitives.triangles.push_back(flat_triangle(corners[0], corners[b], corners[c]));
    scene.material_of.push_back(material);
  }
}

pt::Scene make_room(double lamp) {
  const double power = 4.5 / (lamp * lamp), h = lamp / 2, top = 1.99;
  const pt::Rgb radiance{power, power, power};
  pt::Scene scene;
  scene.materials.resize(4);
  scene.materials[0].albedo = {0.73, 0.73, 0.73};
  scene.materials[1].albedo = {0.65, 0.1, 0.1};
  scene.materials[2].albedo = {0.1, 0.1, 0.65};
  scene.materials[3].albedo = {0, 0, 0};
  scene.materials[3].emission = radiance;
  add_rectangle(scene, {{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}}}, 0);
  add_rectangle(scene, {{{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}}}, 0);
  add_rectangle(scene, {{{-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1}}}, 0);
  add_rectangle(scene, {{{-1, 0, -1}, {-1, 2, -1}, {-1, 2, 1}, {-1, 0, 1}}}, 1);
  add_rectangle(scene, {{{1, 0, -1}, {1, 0, 1}, {1, 2, 1}, {1, 2, -1}}}, 2);
  add_rectangle(scene, {{{-h, top, -h}, {h, top, -h}, {h, top, h}, {-h, top, h}}}, 3);
  scene.primitives.spheres = {{{-0.4, 0.35, -0.3}, 0.35}, {{0.4, 0.35, 0.3}, 0.35}};
  scene.material_of.insert(scene.material_of.end(), {0, 0});
  scene.lights = {
      pt::RectangleLight{{0, top, 0}, {lamp, 0, 0}, {0, 0, lamp}, {0, -1, 0}, radiance}};
  scene.tracer = pt::Tracer(pt::Engine::wide, scene.primitives);
  return scene;
}

}  // namespace

const pt::Scene& room(double lamp) {
  static pt::Scene scene;
  static double made_for = 0;
  if (made_for != lamp) {
    scene = make_room(lamp);
    made_for = lamp;
  }
  return scene;
}

pt::Camera camera_at(double yaw, double pitch) {
  const Vec3 z{std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
  const Vec3 x = normalize(cross({0, 1, 0}, z));
  pt::Camera camera;
  camera.position = Vec3{0, 1, 0} + 4 * z;
  camera.camera_to_world = {x, cross(z, x), z};
  camera.hfov_deg = 40;
  camera.vfov_deg = 30.5;
  return camera;
}

}  // namespace site::live
