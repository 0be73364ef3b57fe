// Ordinary inputs: 120 scenes, with 200 or 3,000 paths for each: furnaces, balls with a point light in the middle, floors beside a wall
// in the sun, and floors in the open. The settings are any bounces up to 6, any chance to survive from 0.5, and both estimators of
// direct light.
#include "pt/tasks/trace_path.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <algorithm>
#include <cmath>

using namespace pt;
using namespace pt::inputs;

struct Input {
  Scene scene;
  SurfacePoint point;
  PathSettings settings;
  Rgb expected;
};

// The sum of a^k over the bounces of the settings.
static double sum_of_powers(double a, const PathSettings& settings) {
  double sum = 0;
  for (int k = std::max(1, settings.from); k <= settings.to; ++k) sum += std::pow(a, k);
  return sum;
}

static Rgb in_a_closed_room(Rgb albedo, const PathSettings& settings) {
  return {sum_of_powers(albedo.r, settings), sum_of_powers(albedo.g, settings),
          sum_of_powers(albedo.b, settings)};
}

static PathSettings any_settings(Sampler& sampler, int kind) {
  PathSettings settings;
  settings.light_samples = 1 + kind % 4;
  settings.survival = kind % 5 == 0 ? 1 : any_number(sampler, 0.5, 1);
  settings.to = static_cast<int>(any_number(sampler, 0, 7));
  settings.from = kind % 3;
  return settings;
}

// The wall of a place, in the sun: the floor has no direct light from it, and the wall shines with the light that it reflects.
static Input beside_a_wall(Sampler& sampler, const PathSettings& settings) {
  Place place;
  Vec3 normal, to_sun;
  do {
    place = any_place(sampler);
    normal = normalize(cross(place.u, place.v));
    to_sun = any_direction(sampler);
  } while (dot(to_sun, normal) < 0.2 || dot(to_sun, place.n) < 0.2);
  const Material wall{"wall", any_color(sampler), {}, ""};
  Scene scene;
  scene.lights = {DirectionalLight{-to_sun, gray(10)}};
  scene = scenes::with_rectangle(scene, place.center, place.u, place.v, wall);
  const Material floor{"floor", any_color(sampler), {}, ""};
  scene = with_floor(scene, place, sampler.next_1d() < 0.5, floor);
  const double share = scenes::share_of_sky(place.p, place.n, place.center, place.u, place.v);
  // Seen from straight above, diffuse_sample has another density here.
  const bool from_above = sampler.next_1d() < 0.5;
  const SurfacePoint point =
      from_above ? scenes::seen(scene, place.p + 0.04 * place.n, place.p) : point_of(scene, place);
  Input input{scene, point, settings, {}};
  input.settings.direct = PathSettings::Direct::lights;
  input.settings.from = input.settings.to = 2;
  const double light = 10 * dot(to_sun, normal) / kPi * share;
  input.expected = {light * wall.albedo.r * floor.albedo.r, light * wall.albedo.g * floor.albedo.g,
                    light * wall.albedo.b * floor.albedo.b};
  return input;
}

static Input any_input(Sampler& sampler, int kind) {
  PathSettings settings = any_settings(sampler, kind);
  const Rgb albedo = 0.9 * any_color(sampler);
  if (kind % 4 == 3) return beside_a_wall(sampler, settings);
  if (kind % 4 == 2) {  // in the open there is direct light only
    settings.direct =
        kind % 8 == 2 ? PathSettings::Direct::hemisphere : PathSettings::Direct::lights;
    const Scene scene = scenes::floor_under_sky();
    const bool direct = settings.from <= 1 && settings.to >= 1;
    return {scene, scenes::middle_of_floor(scene), settings, direct ? scenes::kBrown : Rgb{}};
  }
  const bool is_ball = kind % 4 == 1;
  settings.direct = is_ball ? PathSettings::Direct::lights : PathSettings::Direct::hemisphere;
  const Scene scene = is_ball ? scenes::ball_with_point_light(albedo) : scenes::furnace(albedo);
  const Vec3 eye = 0.3 * any_vector(sampler);
  return {scene, scenes::seen(scene, eye, eye + any_direction(sampler)), settings,
          in_a_closed_room(albedo, settings)};
}

// True if the mean of a channel agrees with what is expected.
static bool agrees(const std::vector<double>& values, double expected) {
  const auto count = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count, variance = std::max(0.0, squares / count - mean * mean);
  return std::abs(mean - expected) <= 8 * std::sqrt(variance / count) + 1e-4 * expected;
}

// Traces paths. Adds the values of the green channel to `parts`, as parts of what is expected.
static bool is_right(const Input& input, int paths, Sampler& sampler, std::vector<double>& parts) {
  std::vector<double> red, green, blue;
  for (int i = 0; i < paths; ++i) {
    const Rgb light = trace_path(input.scene, input.point, input.settings, sampler);
    red.push_back(light.r);
    green.push_back(light.g);
    blue.push_back(light.b);
    if (input.expected.g > 0) parts.push_back(light.g / input.expected.g);
  }
  return agrees(red, input.expected.r) && agrees(green, input.expected.g) &&
         agrees(blue, input.expected.b);
}

EXAMPLE("at most 1 in 100 ordinary inputs differs, and their mean is right") {
  Sampler sampler(1);
  int differ = 0;
  std::vector<double> parts;
  constexpr int kInputs = 120;
  for (int i = 0; i < kInputs; ++i) {
    if (!is_right(any_input(sampler, i), i % 4 == 3 ? 3000 : 200, sampler, parts)) ++differ;
  }
  EXPECT(differ <= 1);
  EXPECT(agrees(parts, 1));
}

// The mean of all these scenes, so that small errors add up.
EXAMPLE("beside a wall in the sun") {
  Sampler sampler(2);
  std::vector<double> parts;
  for (int i = 0; i < 100; ++i) {
    const Input input = beside_a_wall(sampler, any_settings(sampler, i));
    for (int k = 0; k < 40; ++k) {
      const Rgb light = trace_path(input.scene, input.point, input.settings, sampler);
      parts.push_back(light.g / input.expected.g);
    }
  }
  EXPECT(agrees(parts, 1));
}

EXAMPLE("light samples lower the noise") {
  const Scene scene = scenes::furnace(gray(0.5));
  const SurfacePoint point = scenes::seen(scene, {0.1, 0, 0}, {0.3, -1, 0.2});
  PathSettings settings;
  settings.direct = PathSettings::Direct::hemisphere;
  const auto variance = [&](int light_samples) {
    settings.light_samples = light_samples;
    return variance_of(
        1500, [&](Sampler& sampler) { return trace_path(scene, point, settings, sampler).r; });
  };
  const double one = variance(1);
  EXPECT(one > 0);
  EXPECT(variance(16) < 1.3 / 16 * one);
}

EXAMPLE("the same numbers give the same estimate") {
  const Scene scene = scenes::furnace(gray(0.5));
  const SurfacePoint point = scenes::seen(scene, {0.1, 0, 0}, {0.3, -1, 0.2});
  PathSettings settings;
  settings.to = 4;
  EXPECT(repeats([&](Sampler& sampler) { return trace_path(scene, point, settings, sampler); }));
}
