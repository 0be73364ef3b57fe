#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "tests/proof/scenes.h"
#include "tests/proof/statistics.h"

// Lights with a single direction, which have no noise, and the sky.

namespace pt::proof {
namespace {

constexpr Rgb kAlbedo{0.2, 0.5, 0.9};
constexpr Rgb kLight{3, 2, 1};

// A floor at a point of the place, with its normal along the place's z.
SceneBuilder floor_at(const Place& place) {
  SceneBuilder builder;
  builder.quad(place.point({-50, -40, 0}), place.direction({100, 0, 0}),
               place.direction({0, 100, 0}), builder.material(kAlbedo));
  return builder;
}

Rgb direct_at_origin(const SceneBuilder& builder, const Place& place, Engine engine) {
  const Scene scene = builder.finish(engine);
  const SurfacePoint point = point_seen(scene, place.point({0.2, -0.1, 0.4}), place.origin);
  Sampler sampler(41);
  return direct_lights(scene, point, 7, sampler);
}

const Vec3 kDirections[] = {{0, 0, 1}, {0.6, 0, 0.8}, {0.1, -0.7, 0.5}, {-0.9, 0.3, 0.05}};

TEST(PointLight, falls_off_with_the_square_of_the_distance_and_the_cosine) {
  const Place place = askew();
  for (const Vec3 towards : kDirections) {
    for (const double distance : {0.25, 1.0, 40.0}) {
      SceneBuilder builder = floor_at(place);
      const Vec3 local = distance * normalize(towards);
      builder.light(PointLight{place.point(local), kLight});
      for (const Engine engine : kEngines) {
        // The place rounds coordinates of about 2, which matters if the light is near.
        expect_exact(direct_at_origin(builder, place, engine),
                     kAlbedo / kPi * kLight * (local.z / std::pow(distance, 3)), "point light",
                     64 * (1 + 4 / local.z));
      }
    }
  }
}

TEST(DirectionalLight, falls_off_with_the_cosine) {
  const Place place = askew();
  for (const Vec3 towards : kDirections) {
    SceneBuilder builder = floor_at(place);
    const Vec3 unit = normalize(towards);
    builder.light(DirectionalLight{place.direction(-unit), kLight});
    for (const Engine engine : kEngines) {
      expect_exact(direct_at_origin(builder, place, engine), kAlbedo / kPi * kLight * unit.z,
                   "directional light", 64 / unit.z);
    }
  }
}

TEST(DeltaLights, are_dark_from_below_and_in_the_shadow) {
  const Place place = askew();
  for (const Engine engine : kEngines) {
    SceneBuilder below = floor_at(place);
    below.light(PointLight{place.point({0.3, 0, -1}), kLight});
    below.light(DirectionalLight{place.direction({0, 0, 1}), kLight});
    EXPECT_EQ(direct_at_origin(below, place, engine), Rgb{});

    // The ball hides two lamps; a third lamp is nearer than the ball and visible.
    SceneBuilder shadow = floor_at(place);
    shadow.sphere(place.point({0, 0, 2}), 0.5, shadow.material(gray(0.5)));
    shadow.light(PointLight{place.point({0, 0, 4}), kLight});
    shadow.light(DirectionalLight{place.direction({0, 0, -1}), kLight});
    EXPECT_EQ(direct_at_origin(shadow, place, engine), Rgb{});
    shadow.light(PointLight{place.point({0, 0, 1}), kLight});
    expect_exact(direct_at_origin(shadow, place, engine), kAlbedo / kPi * kLight, "nearer", 64 * 5);
  }
}

// A surface that leans by an angle from facing up gets the part (1 + cos) / 2 of the sky's light.
TEST(Sky, lights_by_how_much_of_it_is_seen) {
  for (const double lean : {0.0, 40.0, 90.0, 130.0, 180.0}) {
    const double radians = lean * kPi / 180;
    const Vec3 n = lean == 180 ? Vec3{0, -1, 0} : Vec3{std::sin(radians), std::cos(radians), 0};
    const Place place{frame_from_normal(n), {0.5, 2, -1}};
    SceneBuilder builder;
    builder.quad(place.point({-1, -0.8, 0}), place.direction({2, 0, 0}), place.direction({0, 2, 0}),
                 builder.material(kAlbedo));
    builder.light(AmbientLight{kLight});
    const Rgb truth = lean == 180 ? Rgb{} : kAlbedo * kLight * (0.5 * (1 + std::cos(radians)));
    for (const Engine engine : kEngines) {
      const Scene scene = builder.finish(engine);
      const SurfacePoint point = point_seen(scene, place.point({0.2, -0.1, 0.4}), place.origin);
      Sampler sampler(42);
      RunningRgb lights, hemisphere;
      for (int i = 0; i < 100000; ++i) {
        lights.add(direct_lights(scene, point, 2, sampler));
        hemisphere.add(direct_hemisphere(scene, point, 2, sampler));
      }
      expect_mean(lights, truth, "lights, leaning " + std::to_string(lean));
      expect_mean(hemisphere, truth, "hemisphere, leaning " + std::to_string(lean));
    }
  }
}

// A large sheet hides half of the sky above the floor, the half beyond its edge.
TEST(Sky, is_hidden_by_a_sheet) {
  const Place place{frame_from_normal({0, 1, 0}), {}};
  SceneBuilder builder = floor_at(place);
  builder.quad(place.point({0, -1e6, 1}), place.direction({1e6, 0, 0}),
               place.direction({0, 2e6, 0}), builder.material(gray(0.5)));
  builder.light(AmbientLight{kLight});
  // Beyond the sheet's far edge the sky is open below an elevation of 1e-6: a part of 1e-12.
  const Rgb truth = 0.5 * kAlbedo * kLight;
  for (const Engine engine : kEngines) {
    const Scene scene = builder.finish(engine);
    const SurfacePoint point = point_seen(scene, {0.1, 0.2, 0.1}, {});
    Sampler sampler(43);
    RunningRgb lights;
    for (int i = 0; i < 100000; ++i) lights.add(direct_lights(scene, point, 2, sampler));
    expect_mean(lights, truth, in_words(scene));
  }
}

}  // namespace
}  // namespace pt::proof
