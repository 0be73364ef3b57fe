#pragma once

#include "pt/geometry/ray.h"
#include "pt/scene/scene.h"
#include "pt/scene/view.h"

#include <array>
#include <utility>
#include <vector>

// Scenes for examples, so small that their light can be calculated by hand. y is up, and everything that shines has radiance 1.

namespace pt::scenes {

inline constexpr Rgb kWhite{1, 1, 1};
inline constexpr Rgb kBrown{0.8, 0.4, 0.2};  // the albedo of the floor

// The scene and a rectangle more: its middle, its two whole sides, and its material. It emits to the side of cross(u, v).
inline Scene with_rectangle(Scene scene, Vec3 center, Vec3 u, Vec3 v, const Material& material) {
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

// The scene and a dark rectangle, which hides what is behind it.
inline Scene with_screen(Scene scene, Vec3 center, Vec3 u, Vec3 v) {
  return with_rectangle(std::move(scene), center, u, v, {"dark", {}, {}, ""});
}

// The scene and a rectangle of radiance 1, which is a light too. It shines to the side of cross(u, v).
inline Scene with_lamp(Scene scene, Vec3 center, Vec3 u, Vec3 v, Rgb albedo = {}) {
  scene.lights.push_back(RectangleLight{center, u, v, normalize(cross(u, v)), kWhite});
  return with_rectangle(std::move(scene), center, u, v, {"lamp", albedo, kWhite, ""});
}

// A brown floor, 20 by 20, with its middle in the origin, and these lights, which have no surface.
inline Scene floor_under(const std::vector<Light>& lights) {
  Scene scene;
  scene.lights = lights;
  return with_rectangle(scene, {0, 0, 0}, {0, 0, 20}, {20, 0, 0}, {"floor", kBrown, {}, ""});
}

inline Scene floor_under_sky() { return floor_under({AmbientLight{kWhite}}); }

// A lamp, 2 by 2, at height 1 over the middle of the floor. The middle gets 0.554126 of the light that it would get from a white sky.
inline Scene floor_under_lamp() {
  return with_lamp(floor_under({}), {0, 1, 0}, {2, 0, 0}, {0, 0, 2});
}

// A ball that shines, of radius 1, with its centre 2 above the middle of the floor. The middle gets (1 / 2)^2 of the light that it
// would get from a white sky.
inline Scene floor_under_ball() {
  Scene scene = floor_under({SphereLight{{0, 2, 0}, 1, kWhite}});
  scene.primitives.spheres.push_back({{0, 2, 0}, 1});
  scene.material_of.push_back(static_cast<int>(scene.materials.size()));
  scene.materials.push_back({"lamp", {}, kWhite, ""});
  return scene;
}

// A closed room from -1 to 1 along each axis. All its walls shine inwards, and have this albedo. A bounce multiplies the light by it.
inline Scene furnace(Rgb albedo) {
  const Vec3 x{2, 0, 0}, y{0, 2, 0}, z{0, 0, 2};
  Scene room;
  for (const auto& [u, v] : {std::pair{x, y}, std::pair{y, z}, std::pair{z, x}}) {
    const Vec3 n = normalize(cross(u, v));
    room = with_lamp(with_lamp(room, -n, u, v, albedo), n, v, u, albedo);
  }
  return room;
}

// The inside of a ball of radius 1 with this albedo. A point light in its centre gives each point the irradiance pi, so the direct light
// is the albedo everywhere.
inline Scene ball_with_point_light(Rgb albedo) {
  Scene scene;
  scene.lights = {PointLight{{0, 0, 0}, kPi * kWhite}};
  scene.primitives.spheres = {{{0, 0, 0}, 1}};
  scene.material_of = {0};
  scene.materials = {{"ball", albedo, {}, ""}};
  return scene;
}

// The point of the scene that one sees from `eye` towards `target`.
inline SurfacePoint seen(const Scene& scene, Vec3 eye, Vec3 target) {
  const Ray ray{eye, normalize(target - eye)};
  return surface_point(scene, ray, scene.closest(ray).value());
}

// The middle of the floor, seen from close above.
inline SurfacePoint middle_of_floor(const Scene& scene) {
  return seen(scene, {0, 0.5, 0}, {0, 0, 0});
}

// A rectangle that shines, before black: what view_of sees is 1 where left <= x <= right and bottom <= y <= top, and 0 elsewhere. The
// whole picture is from -1 to 1 along both axes.
inline Scene bright(double left, double right, double bottom, double top, Rgb radiance = kWhite) {
  return with_rectangle({}, {(left + right) / 2, (bottom + top) / 2, -1}, {right - left, 0, 0},
                        {0, top - bottom, 0}, {"bright", {}, radiance, ""});
}

// A picture of 4 by 2 pixels. Pixel (x, y) covers -1 + x / 2 to -1 / 2 + x / 2 of the width, and -1 + y to y of the height. Only emission
// is seen.
inline View view_of(const Scene& scene) {
  View view{scene, {}, {}, 4, 2};
  view.camera.hfov_deg = view.camera.vfov_deg = 90;
  view.settings.to = 0;
  return view;
}

}  // namespace pt::scenes
