#include "pt/examples/scenes.h"

#include "pt/geometry/ray.h"

#include <cmath>
#include <utility>

namespace pt::scenes {

Scene with_rectangle(Scene scene, Vec3 center, Vec3 u, Vec3 v, const Material& material) {
  const Vec3 a = center - 0.5 * u - 0.5 * v, b = a + u, c = b + v, d = a + v;
  for (const Triangle& half : {flat_triangle(a, b, c), flat_triangle(a, c, d)}) {
    scene.primitives.triangles.push_back(half);
    scene.material_of.insert(
        scene.material_of.begin() + static_cast<int>(scene.primitives.triangles.size()) - 1,
        static_cast<int>(scene.materials.size()));
  }
  scene.materials.push_back(material);
  return scene;
}

Scene with_screen(Scene scene, Vec3 center, Vec3 u, Vec3 v) {
  return with_rectangle(std::move(scene), center, u, v, {"dark", {}, {}, ""});
}

Scene with_lamp(Scene scene, Vec3 center, Vec3 u, Vec3 v, Rgb albedo) {
  scene.lights.push_back(RectangleLight{center, u, v, normalize(cross(u, v)), kWhite});
  return with_rectangle(std::move(scene), center, u, v, {"lamp", albedo, kWhite, ""});
}

Scene floor_under(const std::vector<Light>& lights) {
  Scene scene;
  scene.lights = lights;
  return with_rectangle(scene, {0, 0, 0}, {0, 0, 20}, {20, 0, 0}, {"floor", kBrown, {}, ""});
}

Scene floor_under_sky() { return floor_under({AmbientLight{kWhite}}); }

Scene floor_under_lamp() { return with_lamp(floor_under({}), {0, 1, 0}, {2, 0, 0}, {0, 0, 2}); }

Scene floor_under_ball() {
  Scene scene = floor_under({SphereLight{{0, 2, 0}, 1, kWhite}});
  scene.primitives.spheres.push_back({{0, 2, 0}, 1});
  scene.material_of.push_back(static_cast<int>(scene.materials.size()));
  scene.materials.push_back({"lamp", {}, kWhite, ""});
  return scene;
}

Scene furnace(Rgb albedo) {
  const Vec3 x{2, 0, 0}, y{0, 2, 0}, z{0, 0, 2};
  Scene room;
  for (const auto& [u, v] : {std::pair{x, y}, std::pair{y, z}, std::pair{z, x}}) {
    const Vec3 n = normalize(cross(u, v));
    room = with_lamp(with_lamp(room, -n, u, v, albedo), n, v, u, albedo);
  }
  return room;
}

Scene ball_with_point_light(Rgb albedo) {
  Scene scene;
  scene.lights = {PointLight{{0, 0, 0}, kPi * kWhite}};
  scene.primitives.spheres = {{{0, 0, 0}, 1}};
  scene.material_of = {0};
  scene.materials = {{"ball", albedo, {}, ""}};
  return scene;
}

SurfacePoint seen(const Scene& scene, Vec3 eye, Vec3 target) {
  const Ray ray{eye, normalize(target - eye)};
  return surface_point(scene, ray, scene.closest(ray).value());
}

SurfacePoint middle_of_floor(const Scene& scene) { return seen(scene, {0, 0.5, 0}, {0, 0, 0}); }

// The sum over the edges of the angle under which p sees the edge, times the cosine of the plane through p and the edge.
double share_of_sky(Vec3 p, Vec3 n, Vec3 center, Vec3 u, Vec3 v) {
  const Vec3 a = center - 0.5 * u - 0.5 * v - p;
  const Vec3 corners[] = {a, a + u, a + u + v, a + v};
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec3 from = corners[i], to = corners[(i + 1) % 4], across = cross(from, to);
    sum += std::atan2(length(across), dot(from, to)) * dot(n, across) / length(across);
  }
  return std::abs(sum) / (2 * kPi);
}

Scene bright(double left, double right, double bottom, double top, Rgb radiance) {
  return with_rectangle({}, {(left + right) / 2, (bottom + top) / 2, -1}, {right - left, 0, 0},
                        {0, top - bottom, 0}, {"bright", {}, radiance, ""});
}

View view_of(const Scene& scene) {
  View view{scene, {}, {}, 4, 2};
  view.camera.hfov_deg = view.camera.vfov_deg = 90;
  view.settings.to = 0;
  return view;
}

}  // namespace pt::scenes
