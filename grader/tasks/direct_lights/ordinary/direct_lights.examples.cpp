// Ordinary inputs: 240 floors in every orientation, seen from their front or their back, some of which shine themselves, under one or two
// lights of every kind, some of them below the floor, turned away, or behind a screen. Each is estimated with 24 calls of 1 to 16
// samples.
#include "pt/tasks/direct_lights.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <algorithm>
#include <cmath>

using namespace pt;
using namespace pt::inputs;

// A scene without its floor, and its light at p as a part of the light of a white sky.
struct Lit {
  Scene scene;
  double share = 0;
};

static void add_lamp(Lit& lit, const Place& place, double light, int kind) {
  const bool turned = kind % 4 == 3;
  const Vec3 u = turned ? place.v : place.u, v = turned ? place.u : place.v;
  const Vec3 n = normalize(cross(u, v));
  lit.scene.lights.push_back(RectangleLight{place.center, u, v, n, gray(light)});
  lit.scene = scenes::with_rectangle(lit.scene, place.center, u, v,
                                     {"lamp", {0.3, 0.3, 0.3}, gray(light), ""});
  if (!turned)
    lit.share += light * scenes::share_of_sky(place.p, place.n, place.center, place.u, place.v);
}

static void add_ball(Lit& lit, const Place& place, double light) {
  const Vec3 way = place.center - place.p;
  const double height = dot(way, place.n), radius = 0.6 * height;
  lit.scene.lights.push_back(SphereLight{place.center, radius, gray(light)});
  lit.scene.primitives.spheres.push_back({place.center, radius});
  lit.scene.material_of.push_back(static_cast<int>(lit.scene.materials.size()));
  lit.scene.materials.push_back({"ball", {0.3, 0.3, 0.3}, gray(light), ""});
  lit.share += light * std::pow(radius / length(way), 2) * height / length(way);
}

// A direction of light: a cosine below zero comes from below the floor.
static void add_point(Lit& lit, const Place& place, double light, Vec3 way) {
  lit.scene.lights.push_back(PointLight{place.p + way, gray(light)});
  const double cosine = dot(normalize(way), place.n);
  lit.share += light * std::max(0.0, cosine) / dot(way, way) / kPi;
}

static void add_sun(Lit& lit, const Place& place, double light, Vec3 way) {
  lit.scene.lights.push_back(DirectionalLight{-normalize(way), gray(light)});
  lit.share += light * std::max(0.0, dot(normalize(way), place.n)) / kPi;
}

static Lit any_light(Sampler& sampler, const Place& place, int kind) {
  const double light = std::pow(10, any_number(sampler, -1, 2));
  const Vec3 way = place.center - place.p, low = way - 2 * dot(way, place.n) * place.n;
  Lit lit;
  switch (kind % 8) {
    case 0:
      add_lamp(lit, place, light, kind / 8);
      break;
    case 1:
      add_ball(lit, place, light);
      break;
    case 2:
      add_point(lit, place, light, way);
      break;
    case 3:
      add_sun(lit, place, light, way);
      break;
    case 4:
      lit.scene.lights = {AmbientLight{gray(light)}};
      lit.scene = scenes::with_screen(lit.scene, place.center, place.u, place.v);
      lit.share =
          light * (1 - scenes::share_of_sky(place.p, place.n, place.center, place.u, place.v));
      break;
    case 5:
      add_point(lit, place, light, low);
      add_lamp(lit, place, light, kind / 8);
      break;
    case 6:
      add_ball(lit, place, light);
      add_sun(lit, place, light, low);
      break;
    default:
      add_point(lit, place, light, 0.3 * way);
      add_sun(lit, place, light, frame_from_normal(place.n).to_world({0.3, 0.2, 0.5}));
  }
  if (kind % 8 < 4 && kind % 5 == 0) {  // a screen that hides all of it
    const Frame frame = frame_from_normal(normalize(way));
    lit.scene = scenes::with_screen(lit.scene, place.p + 0.2 * way, 3 * frame.x, 3 * frame.y);
    lit.share = 0;
  }
  return lit;
}

static bool is_right(const Lit& lit, const Place& place, int kind, int samples, Sampler& sampler) {
  Material floor{"floor", any_color(sampler), {}, ""};
  floor.albedo.g = any_number(sampler, 0.2, 1);
  if (kind % 3 == 0) floor.emission = {2, 2, 2};
  const Scene scene = with_floor(lit.scene, place, kind % 2 == 0, floor);
  const SurfacePoint point = point_of(scene, place);
  const Rgb expected = lit.share * floor.albedo;
  constexpr int kCalls = 24;
  double sum = 0, squares = 0;
  bool is_tinted = true;
  for (int i = 0; i < kCalls; ++i) {
    const Rgb light = direct_lights(scene, point, samples, sampler);
    sum += light.g;
    squares += light.g * light.g;
    const double red = light.r * floor.albedo.g - light.g * floor.albedo.r;
    const double blue = light.b * floor.albedo.g - light.g * floor.albedo.b;
    is_tinted = is_tinted && std::abs(red) + std::abs(blue) <= 1e-4 * (light.g + 1e-9);
  }
  const double mean = sum / kCalls;
  const double variance = std::max(0.0, squares / kCalls - mean * mean) / (kCalls - 1);
  const bool exact = std::all_of(scene.lights.begin(), scene.lights.end(), is_delta);
  const double noise = exact ? 0 : 6 * std::sqrt(variance);
  return is_tinted && std::abs(mean - expected.g) <= noise + 1e-4 * expected.g;
}

EXAMPLE("less than 1 in 100 ordinary inputs differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 240;
  for (int i = 0; i < kInputs; ++i) {
    const bool under_sky = i % 8 == 4;
    const Place place = under_sky ? any_place_on_floor(sampler, {0, 1, 0}) : any_place(sampler);
    const Lit lit = any_light(sampler, place, i);
    if (!is_right(lit, place, i, 1 << (i % 5), sampler)) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}

EXAMPLE("the noise falls with the number of samples") {
  const Scene scene = scenes::floor_under_lamp();
  const SurfacePoint point = scenes::middle_of_floor(scene);
  const auto variance = [&](int samples) {
    return variance_of(
        1000, [&](Sampler& sampler) { return direct_lights(scene, point, samples, sampler).r; });
  };
  const double one = variance(1);
  EXPECT(one > 0);
  EXPECT(variance(4) < 1.3 / 4 * one);
  EXPECT(variance(64) < 1.3 / 64 * one);
}

EXAMPLE("the same numbers give the same estimate") {
  const Scene scene = scenes::floor_under_lamp();
  const SurfacePoint point = scenes::middle_of_floor(scene);
  EXPECT(repeats([&](Sampler& sampler) { return direct_lights(scene, point, 4, sampler); }));
}
