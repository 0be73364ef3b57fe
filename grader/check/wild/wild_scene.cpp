#include "grader/check/wild/wild_scene.h"

#include <cmath>
#include <utility>

namespace grader::check {

using pt::Rgb;
using pt::Vec3;
using Kind = WildLight::Kind;

double by_size(RandomNumbers& random, double low, double high) {
  return low * std::pow(high / low, random.between(0, 1));
}

namespace {

Vec3 any_direction(RandomNumbers& random) {
  const double z = random.between(-1, 1), phi = random.between(0, 2 * pt::kPi);
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// The same, higher than `low` above the horizon.
Vec3 direction_over(RandomNumbers& random, double low) {
  for (;;) {
    const Vec3 direction = any_direction(random);
    if (direction.z > low) return direction;
  }
}

Rgb any_color(RandomNumbers& random, double low, double high) {
  const double r = random.between(low, high), g = random.between(low, high);
  return {r, g, random.between(low, high)};
}

Rgb any_albedo(RandomNumbers& random) {
  switch (random.whole(0, 9)) {
    case 0:
      return {};
    case 1:
    case 2:
    case 3:
      return pt::gray(by_size(random, 1e-3, 1));
    case 4:
      return any_color(random, 0, 1) * by_size(random, 1e-2, 1);
    default:
      return any_color(random, 0, 1);
  }
}

Rgb some_emission(RandomNumbers& random) {
  return by_chance(random, 0.2) ? any_color(random, 0, 1) : Rgb{};
}

void add_rectangle(RandomNumbers& random, double distance, WildLight& light) {
  const Vec3 facing = by_chance(random, 0.8)
                          ? -normalize(normalize(light.at) + 0.5 * any_direction(random))
                          : any_direction(random);
  const pt::Frame frame = pt::frame_from_normal(facing);
  const double most = by_chance(random, 0.2) ? 1e4 : 1e1;
  light.u = distance * by_size(random, 1e-2, most) * frame.x;
  light.v = distance * by_size(random, 1e-2, most) * frame.y;
  if (by_chance(random, 0.25)) light.u = -light.u;  // now it turns its dark side
  if (by_chance(random, 0.5)) std::swap(light.u, light.v), light.u = -light.u;
}

WildLight any_light(RandomNumbers& random) {
  WildLight light;
  const double distance = by_size(random, 1e-2, 1e2);
  light.kind = std::array{Kind::rectangle, Kind::rectangle,   Kind::ball, Kind::cube,
                          Kind::point,     Kind::directional, Kind::sky}[random.whole(0, 6)];
  light.at =
      distance * (by_chance(random, 0.15) ? any_direction(random) : direction_over(random, -0.2));
  light.radiance = any_color(random, 0.2, 1) * by_size(random, 1e-2, 1e2);
  light.has_body = by_chance(random, 0.5);
  if (light.kind == Kind::rectangle) add_rectangle(random, distance, light);
  if (light.kind == Kind::ball) light.radius = distance * by_size(random, 1e-3, 0.9);
  if (light.kind == Kind::cube) {
    const pt::Frame frame = pt::frame_from_normal(any_direction(random));
    const double edge = 2 * distance * by_size(random, 1e-2, 0.4);
    light.u = edge * frame.x;
    light.v = edge * frame.y;
  }
  if (light.kind == Kind::point) light.radiance *= distance * distance;
  if (light.kind == Kind::directional) light.at = normalize(light.at);
  return light;
}

WildSurface any_surface(RandomNumbers& random) {
  WildSurface surface;
  const double distance = by_size(random, 1e-3, 3), size = distance * by_size(random, 1e-2, 2);
  surface.at = distance * direction_over(random, 0);
  surface.albedo = any_albedo(random);
  surface.emission = some_emission(random);
  if (by_chance(random, 0.3)) {
    surface.radius = 0.4 * std::min(size, distance);
  } else {
    const Vec3 center = surface.at;
    surface.at = center + size * any_direction(random);
    surface.p1 = center + size * any_direction(random);
    surface.p2 = center + size * any_direction(random);
  }
  return surface;
}

WildRoom any_room(RandomNumbers& random) {
  WildRoom room;
  room.half = by_size(random, 3, 100);
  room.center = 0.5 * room.half * any_direction(random);
  const bool glows = by_chance(random, 0.3);
  for (Rgb& albedo : room.albedo) albedo = any_albedo(random);
  for (Rgb& emission : room.emission) emission = glows ? any_color(random, 0, 1) : Rgb{};
  return room;
}

// A view from above both normals, and not quite along the surface.
Vec3 any_view_of(RandomNumbers& random, Vec3 true_normal) {
  for (int tried = 0; tried < 100; ++tried) {
    const Vec3 wo = any_direction(random);
    if (std::abs(wo.z) > 0.02 && wo.z * dot(wo, true_normal) > 0) return wo.z > 0 ? wo : -wo;
  }
  return normalize(true_normal + Vec3{0, 0, 1});
}

template <class Change>
void add(std::vector<WildScene>& all, const WildScene& scene, const Change& change) {
  WildScene smaller = scene;
  change(smaller);
  all.push_back(std::move(smaller));
}

}  // namespace

WildScene wild_scene(RandomNumbers& random, bool rooms) {
  WildScene scene;
  scene.size = by_size(random, 1e-3, 1e3);
  if (by_chance(random, 0.25)) scene.away = by_size(random, 1, 1e4) * any_direction(random);
  scene.up = any_direction(random);
  if (by_chance(random, 0.5)) {
    const double tilt = by_size(random, 1e-5, 1), phi = random.between(0, 2 * pt::kPi);
    scene.true_normal = {std::sin(tilt) * std::cos(phi), std::sin(tilt) * std::sin(phi),
                         std::cos(tilt)};
  }
  scene.side = by_size(random, 1e-2, 10);
  scene.albedo = any_albedo(random);
  scene.emission = some_emission(random);
  scene.wo = any_view_of(random, scene.true_normal);
  scene.seen_from = by_size(random, 1e-2, 10);
  bool has_sky = false;
  for (int left = by_chance(random, 0.1) ? 0 : random.whole(1, 3); left > 0; --left) {
    const WildLight light = any_light(random);
    if (light.kind == Kind::sky && has_sky) continue;
    has_sky = has_sky || light.kind == Kind::sky;
    scene.lights.push_back(light);
  }
  for (int left = random.whole(0, 4); left > 0; --left)
    scene.surfaces.push_back(any_surface(random));
  if (rooms && by_chance(random, 0.6)) scene.room = any_room(random);
  return scene;
}

std::vector<WildScene> smaller(const WildScene& scene) {
  std::vector<WildScene> all;
  if (scene.room) add(all, scene, [](WildScene& s) { s.room.reset(); });
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    add(all, scene,
        [&](WildScene& s) { s.surfaces.erase(s.surfaces.begin() + std::ptrdiff_t(i)); });
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    add(all, scene, [&](WildScene& s) { s.lights.erase(s.lights.begin() + std::ptrdiff_t(i)); });
    if (scene.lights[i].has_body) {
      add(all, scene, [&](WildScene& s) { s.lights[i].has_body = false; });
    }
    if (!(scene.lights[i].radiance == pt::gray(1))) {
      add(all, scene, [&](WildScene& s) { s.lights[i].radiance = pt::gray(1); });
    }
  }
  if (length(scene.away) > 0) add(all, scene, [](WildScene& s) { s.away = {}; });
  if (scene.size != 1) add(all, scene, [](WildScene& s) { s.size = 1; });
  if (scene.true_normal.z != 1) add(all, scene, [](WildScene& s) { s.true_normal = {0, 0, 1}; });
  if (scene.up.z != 1) add(all, scene, [](WildScene& s) { s.up = {0, 0, 1}; });
  if (!is_black(scene.emission)) add(all, scene, [](WildScene& s) { s.emission = {}; });
  if (!(scene.albedo == pt::gray(0.5))) {
    add(all, scene, [](WildScene& s) { s.albedo = pt::gray(0.5); });
  }
  if (scene.wo.z != 1) add(all, scene, [](WildScene& s) { s.wo = {0, 0, 1}; });
  return all;
}

}  // namespace grader::check
