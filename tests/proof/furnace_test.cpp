#include "pt/render/radiance.h"
#include "pt/sampling/directions.h"
#include "tests/proof/scenes.h"
#include "tests/proof/statistics.h"

// A closed room whose walls all emit E and reflect the part a of the light: after m bounces the
// radiance is E (1 + a + ... + a^m) everywhere and in all directions.

namespace pt::proof {
namespace {

using Direct = PathSettings::Direct;

constexpr Rgb kEmission{2, 1, 0.5};

double furnace(double emission, double albedo, int bounces) {
  return emission * (1 - std::pow(albedo, bounces + 1)) / (1 - albedo);
}

Rgb furnace(Rgb albedo, int bounces) {
  return {furnace(kEmission.r, albedo.r, bounces), furnace(kEmission.g, albedo.g, bounces),
          furnace(kEmission.b, albedo.b, bounces)};
}

Scene room(Engine engine, Rgb albedo) {
  SceneBuilder builder;
  builder.room({-1, -0.5, -2}, {1, 1, 1.5}, builder.material(albedo, kEmission));
  builder.light(mesh_light(builder.triangles(), kEmission));
  return builder.finish(engine);
}

// Rays from a point in the room in all directions.
RunningRgb look_around(const Scene& scene, const PathSettings& settings, int rays) {
  Sampler sampler(11);
  RunningRgb samples;
  for (int i = 0; i < rays; ++i) {
    Vec3 direction = uniform_hemisphere(sampler.next_2d());
    if (i % 2 == 1) direction = -direction;
    samples.add(radiance(scene, {{0.2, 0.1, 0.3}, direction, 0, kInfinity}, settings, sampler));
  }
  return samples;
}

// With survival p, the variance is the sum over k of (a^2 / p)^k, and the error of its estimate
// depends on the sum of (a^4 / p^3)^k. For each albedo both ratios are below one, so z is normal.
void expect_furnace(Rgb albedo, double survival, int rays) {
  for (const Engine engine : kEngines) {
    const Scene scene = room(engine, albedo);
    for (const int bounces : {0, 1, 2, 5, 50}) {
      PathSettings settings;
      settings.direct = Direct::hemisphere;
      settings.survival = survival;
      settings.to = bounces;
      expect_mean(look_around(scene, settings, rays), furnace(albedo, bounces),
                  in_words(scene) + ", m = " + std::to_string(bounces));
    }
  }
}

TEST(Furnace, glows_as_the_closed_form_says) { expect_furnace({0.2, 0.5, 0.65}, 0.7, 40000); }

TEST(Furnace, does_not_depend_on_survival) {
  expect_furnace({0.1, 0.2, 0.3}, 0.3, 40000);
  expect_furnace({0.3, 0.5, 0.8}, 1, 2500);
}

TEST(Furnace, adds_up_only_the_bounces_asked_for) {
  const Rgb albedo{0.2, 0.5, 0.65};
  const Scene scene = room(Engine::task, albedo);
  PathSettings settings;
  settings.direct = Direct::hemisphere;
  settings.from = 2;
  settings.to = 4;
  expect_mean(look_around(scene, settings, 60000), furnace(albedo, 4) - furnace(albedo, 1),
              "2 to 4");
  settings.from = settings.to = 3;
  expect_mean(look_around(scene, settings, 60000), furnace(albedo, 3) - furnace(albedo, 2),
              "3 alone");
  settings.from = settings.to = 0;
  expect_mean(look_around(scene, settings, 100), kEmission, "0 alone");
}

TEST(Furnace, does_not_depend_on_the_number_of_light_samples) {
  const Rgb albedo{0.2, 0.5, 0.65};
  const Scene scene = room(Engine::task, albedo);
  PathSettings settings;
  settings.direct = Direct::hemisphere;
  settings.to = 2;
  settings.light_samples = 5;
  expect_mean(look_around(scene, settings, 20000), furnace(albedo, 2), "five samples");
}

// Points near an edge of the room see its other wall at 1 / r^2, so area sampling of this wall has
// infinite variance over all paths. At a point the variance is finite, so this test has one bounce
// and points away from the edges. (Many bounces with lights: interreflection_test.cpp.)
TEST(Furnace, glows_the_same_by_sampling_its_walls) {
  const Rgb albedo{0.2, 0.5, 0.65};
  for (const Engine engine : kEngines) {
    const Scene scene = room(engine, albedo);
    PathSettings settings;
    for (const Vec3 target : {Vec3{0, -0.5, 0}, Vec3{-1, 0.2, -0.4}, Vec3{0.4, 0.3, 1.5}}) {
      const Vec3 eye{0.2, 0.1, 0.3};
      const Ray ray{eye, normalize(target - eye), 0, kInfinity};
      Sampler sampler(12);
      RunningRgb samples;
      for (int i = 0; i < 100000; ++i) samples.add(radiance(scene, ray, settings, sampler));
      expect_mean(samples, furnace(albedo, 1), in_words(scene));
    }
  }
}

// The back of an emitter is dark: the same room seen from outside, and a glowing ball seen from
// inside.
TEST(Furnace, is_dark_from_behind) {
  SceneBuilder builder;
  const int glowing = builder.material(gray(0), kEmission);
  builder.room({-1, -1, -1}, {1, 1, 1}, glowing);
  builder.sphere({10, 0, 0}, 1, glowing);
  for (const Engine engine : kEngines) {
    const Scene scene = builder.finish(engine);
    EXPECT_EQ(point_seen(scene, {0, 5, 1}, {0.1, 0, 0}).emission, Rgb{});
    EXPECT_EQ(point_seen(scene, {0, 0, 0}, {0.3, 1, 0.2}).emission, kEmission);
    EXPECT_EQ(point_seen(scene, {10, 0, 0}, {10.3, 1, 0.2}).emission, Rgb{});
    EXPECT_EQ(point_seen(scene, {10, 5, 0}, {10, 0, 0}).emission, kEmission);
  }
}

}  // namespace
}  // namespace pt::proof
