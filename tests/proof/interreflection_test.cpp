#include "pt/tasks/trace_path.h"
#include "tests/proof/closed_forms.h"
#include "tests/proof/scenes.h"
#include "tests/proof/statistics.h"

// Light after two or more bounces, in scenes with an exact answer.

namespace pt::proof {
namespace {

using Direct = PathSettings::Direct;

constexpr Rgb kAlbedo{0.2, 0.5, 0.65};

RunningRgb trace(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
                 int paths) {
  Sampler sampler(21);
  RunningRgb samples;
  for (int i = 0; i < paths; ++i) samples.add(trace_path(scene, point, settings, sampler));
  return samples;
}

Rgb power(Rgb base, int exponent) {
  Rgb product = gray(1);
  for (int i = 0; i < exponent; ++i) product *= base;
  return product;
}

struct Lamp {
  Light light;
  Rgb flux;  // all light that leaves the lamp
};

// Lamps without a surface, which light a room and hide nothing in it.
std::vector<Lamp> lamps() {
  const Rgb radiance{3, 2, 1};
  const Vec3 u{0.3, 0, 0.1}, v{0, 0.2, 0.1};
  const Vec3 p0{-0.1, 0.3, 0.2}, p1{0.3, 0.2, 0.2}, p2{0, 0.1, 0.5}, p3{-0.2, -0.2, 0.3};
  const double mesh_area =
      0.5 * (length(cross(p1 - p0, p2 - p0)) + length(cross(p2 - p0, p3 - p0)));
  return {
      {PointLight{{0.3, -0.2, 0.25}, radiance}, 4 * kPi * radiance},
      {RectangleLight{{0.2, 0.1, -0.3}, u, v, normalize(cross(u, v)), radiance},
       kPi * length(cross(u, v)) * radiance},
      {SphereLight{{-0.3, 0.2, 0.1}, 0.2, radiance}, 4 * kPi * kPi * 0.04 * radiance},
      {make_mesh_light({{p0, p1, p2}, {p0, p2, p3}}, radiance), kPi * mesh_area * radiance},
  };
}

// Ulbricht 1900: seen from any inner point of a sphere, the apparent size of any part depends only
// on its area. So light that was reflected once is even, wherever the lamp is. After k >= 2 bounces
// the radiance is a^k flux / (pi 4 pi R^2).
TEST(Interreflection, is_even_in_a_sphere_whatever_the_lamp) {
  const double radius = 1.5;
  for (const Engine engine : kEngines) {
    for (const Lamp& lamp : lamps()) {
      const std::string lamp_name = "lamp " + std::to_string(lamp.light.index());
      SceneBuilder builder;
      builder.sphere({0.1, 0, 0}, radius, builder.material(kAlbedo));
      builder.light(lamp.light);
      const Scene scene = builder.finish(engine);
      const SurfacePoint point = point_seen(scene, {0.5, 0.5, 0}, {0.2, 0.9, 0.8});
      const double area = 4 * kPi * radius * radius;
      Rgb all_from_two;
      for (int k = 2; k <= 40; ++k) {
        const Rgb truth = power(kAlbedo, k) * lamp.flux / (kPi * area);
        all_from_two += truth;
        if (k > 4) continue;
        PathSettings settings;
        settings.from = settings.to = k;
        expect_mean(trace(scene, point, settings, 30000), truth,
                    lamp_name + ", bounce " + std::to_string(k));
      }
      PathSettings settings;
      settings.from = 2;
      settings.to = 40;
      expect_mean(trace(scene, point, settings, 30000), all_from_two,
                  lamp_name + ", all bounces from the second");
    }
  }
}

// A glowing ball in the middle of a larger sphere. By symmetry both are evenly lit, and the part (r
// / R)^2 of the light from the wall hits the ball. Two numbers describe each bounce.
TEST(Interreflection, goes_between_a_ball_and_the_sphere_around_it) {
  const double inner = 0.4, outer = 1;
  const Rgb ball_albedo{0.6, 0.3, 0.1}, emission{1, 2, 3};
  SceneBuilder builder;
  builder.sphere({}, outer, builder.material(kAlbedo));
  builder.sphere({}, inner, builder.material(ball_albedo, emission));
  builder.light(SphereLight{{}, inner, emission});
  const double meets_ball = inner * inner / (outer * outer);

  for (const Engine engine : kEngines) {
    const Scene scene = builder.finish(engine);
    const SurfacePoint wall = point_seen(scene, {0, 0.8, 0}, {0.3, 1, 0.2});
    const SurfacePoint ball = point_seen(scene, {0, 0.8, 0}, {0.1, 0, 0.1});
    for (const Direct direct : {Direct::lights, Direct::hemisphere}) {
      Rgb of_wall, of_ball = emission;
      for (int k = 1; k <= 4; ++k) {
        const Rgb next = kAlbedo * ((1 - meets_ball) * of_wall + meets_ball * of_ball);
        of_ball = ball_albedo * of_wall;
        of_wall = next;
        PathSettings settings;
        settings.direct = direct;
        settings.from = settings.to = k;
        const std::string what = in_words(scene) + ", bounce " + std::to_string(k);
        expect_mean(trace(scene, wall, settings, 40000), of_wall, what + " on the wall");
        expect_mean(trace(scene, ball, settings, 40000), of_ball, what + " on the ball");
      }
    }
  }
}

// Floor and wall share an edge, at any angle from a right angle up, and the sun shines straight
// down on both. Each is evenly lit, so the second bounce on the other is Lambert's formula.
TEST(Interreflection, goes_between_two_walls_of_any_tilt) {
  const Rgb floor_albedo{0.8, 0.5, 0.2}, wall_albedo{0.3, 0.6, 0.9}, sun{4, 3, 2};
  for (const double opening : {90.0, 110.0, 150.0}) {
    const double radians = opening * kPi / 180;
    const Vec3 along{2, 0, 0}, floor_side{0, 0, 1};
    const Vec3 wall_side{0, std::sin(radians), std::cos(radians)};
    const Vec3 wall_normal{0, -std::cos(radians), std::sin(radians)};
    const double wall_cosine = std::max(0.0, wall_normal.y);

    SceneBuilder builder;
    builder.quad({}, floor_side, along, builder.material(floor_albedo));
    builder.quad({}, along, 1.5 * wall_side, builder.material(wall_albedo));
    builder.light(DirectionalLight{{0, -1, 0}, sun});
    const Polygon floor{{}, along, along + floor_side, floor_side};
    const Polygon wall{{}, along, along + 1.5 * wall_side, 1.5 * wall_side};

    for (const Engine engine : kEngines) {
      const Scene scene = builder.finish(engine);
      const Vec3 eye = 3 * normalize(wall_normal + Vec3{0.3, 1, 0});
      const SurfacePoint on_wall = point_seen(scene, eye, Vec3{0.7, 0, 0} + 0.6 * wall_side);
      const SurfacePoint on_floor = point_seen(scene, eye, Vec3{1.2, 0, 0} + 0.3 * floor_side);
      PathSettings settings;
      settings.from = settings.to = 2;
      const std::string what = in_words(scene) + ", opening " + std::to_string(opening);
      expect_mean(trace(scene, on_wall, settings, 100000),
                  wall_albedo / kPi * lambert_irradiance(on_wall.p, wall_normal, floor) *
                      (floor_albedo / kPi * sun),
                  what + ", wall");
      expect_mean(trace(scene, on_floor, settings, 100000),
                  floor_albedo / kPi * lambert_irradiance(on_floor.p, {0, 1, 0}, wall) *
                      (wall_albedo / kPi * sun * wall_cosine),
                  what + ", floor");
    }
  }
}

}  // namespace
}  // namespace pt::proof
