#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "tests/proof/closed_forms.h"
#include "tests/proof/scenes.h"
#include "tests/proof/statistics.h"

#include <initializer_list>
#include <variant>

// Rectangular, mesh and spherical lights, compared with Lambert's polygon formula and the
// irradiance from a sphere, for both ways of sampling direct light.

namespace pt::proof {
namespace {

constexpr Rgb kRadiance{3, 2, 1};
constexpr Rgb kAlbedo{0.2, 0.5, 0.9};

using Estimator = Rgb (*)(const Scene&, const SurfacePoint&, int, Sampler&);

RunningRgb repeat(Estimator direct, const Scene& scene, const SurfacePoint& point, int calls,
                  int samples = 4) {
  Sampler sampler(31);
  RunningRgb all;
  for (int i = 0; i < calls; ++i) all.add(direct(scene, point, samples, sampler));
  return all;
}

// The reflected irradiance from a light of radiance 1.
Rgb reflected(double irradiance) { return irradiance / kPi * kRadiance * kAlbedo; }

struct Rectangle {
  const char* name;
  Vec3 center, u, v;  // emits along cross(u, v)
  bool noisy;         // too small for hemisphere sampling
};

// The light around a receiver at the origin with its normal along z.
const Rectangle kRectangles[] = {
    {"overhead", {0, 0, 2}, {0, 1, 0}, {1, 0, 0}, false},
    {"near", {0.1, 0, 0.15}, {0, 1, 0}, {1, 0, 0}, false},
    {"far", {3, 4, 20}, {0, 1, 0}, {1, 0, 0}, true},
    {"long and tilted", {0.5, 1, 1}, {0, 0.5, -0.5}, {2, 0, 0.3}, false},
    {"upright", {1, 0, 0.7}, {0, 0, 1}, {0, 1.5, 0}, false},
    {"half below the horizon", {1, 0, 0.2}, {0, 0, 1}, {0, 1.5, 0}, false},
    {"sheared", {-1, 0.2, 1}, {0.3, 1, 0.2}, {1, 0.4, -0.4}, false},
};

// The light and its surface, once as a rectangle and once as a mesh.
void add_light(SceneBuilder& builder, const Place& place, const Rectangle& r, bool as_mesh) {
  const Vec3 center = place.point(r.center), u = place.direction(r.u), v = place.direction(r.v);
  SceneBuilder light;
  light.quad(center - 0.5 * u - 0.5 * v, u, v, light.material(gray(0)));
  builder.quad(center - 0.5 * u - 0.5 * v, u, v, builder.material(gray(0), kRadiance));
  if (as_mesh) {
    builder.light(mesh_light(light.triangles(), kRadiance));
  } else {
    builder.light(RectangleLight{center, u, v, normalize(cross(u, v)), kRadiance});
  }
}

void add_receiver(SceneBuilder& builder, const Place& place) {
  builder.quad(place.point({-0.1, -0.08, 0}), place.direction({0.2, 0, 0}),
               place.direction({0, 0.2, 0}), builder.material(kAlbedo));
}

double irradiance(const Place& place, const Polygon& local) {
  Polygon world;
  for (const Vec3 corner : local) world.push_back(place.point(corner));
  return lambert_irradiance(place.origin, place.direction({0, 0, 1}), world);
}

SurfacePoint receiver(const Scene& scene, const Place& place, double height = 0.05) {
  return point_seen(scene, place.point({0.03, 0.02, height}), place.origin);
}

TEST(RectangleLight, matches_lamberts_formula) {
  const Place place = askew();
  for (const Rectangle& r : kRectangles) {
    for (const bool as_mesh : {false, true}) {
      SceneBuilder builder;
      add_receiver(builder, place);
      add_light(builder, place, r, as_mesh);
      const Rgb truth = reflected(irradiance(place, parallelogram(r.center, r.u, r.v)));
      ASSERT_GT(truth.r, 0) << r.name;
      for (const Engine engine : kEngines) {
        const Scene scene = builder.finish(engine);
        const SurfacePoint point = receiver(scene, place);
        expect_mean(repeat(direct_lights, scene, point, 20000), truth, r.name);
        if (r.noisy || as_mesh) continue;
        expect_mean(repeat(direct_hemisphere, scene, point, 40000), truth,
                    std::string(r.name) + ", hemisphere");
      }
    }
  }
}

// A lamp so small that all of it is equally far.
TEST(RectangleLight, as_in_the_course_is_stronger_by_the_distance) {
  const Place place = askew();
  const Rectangle small{"small", {0, 0, 2.5}, {0, 0.02, 0}, {0.02, 0, 0}, true};
  SceneBuilder builder;
  add_receiver(builder, place);
  add_light(builder, place, small, false);
  Scene scene = builder.finish(Engine::wide);
  RectangleLight& light = std::get<RectangleLight>(scene.lights[0]);
  light.as_in_cs184 = true;
  const SurfacePoint point = receiver(scene, place);
  const Rgb truth =
      2.5 * reflected(irradiance(place, parallelogram(small.center, small.u, small.v)));
  const auto expect_near = [&](Rgb reflected_light, const char* how) {
    EXPECT_NEAR(reflected_light.g / truth.g, 1, 1e-4) << how;
  };
  Sampler sampler(41);
  expect_near(direct_lights(scene, point, 2000, sampler), "one by one");
  Rgb sum;
  for (int i = 0; i < 250; ++i) {
    LightSampleGroup group;
    sample_light_group(light, point.p, kLightGroup, sampler, group);
    for (int k = 0; k < kLightGroup; ++k) {
      sum += kAlbedo / kPi * group.radiance * dot(group.wi_of(k), point.n) / group.pdf[k];
    }
  }
  expect_near(sum / (250 * kLightGroup), "in groups");
}

// A point in the plane of the light or behind it gets no light at all, nor does a point that is
// seen from its side away from the light.
TEST(RectangleLight, is_dark_on_the_other_sides) {
  const Rectangle turned_away{"", {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, false};
  const Rectangle below{"", {0, 0, -2}, {1, 0, 0}, {0, 1, 0}, false};
  const Rectangle level{"", {1, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, false};
  for (const Rectangle& r : {turned_away, below, level, kRectangles[0]}) {
    const Place place = askew();
    SceneBuilder builder;
    add_receiver(builder, place);
    add_light(builder, place, r, false);
    const Scene scene = builder.finish(Engine::task);
    const bool from_behind = r.center.z > 0 && r.u.y > 0;
    const SurfacePoint point = receiver(scene, place, from_behind ? -0.05 : 0.05);
    for (const Estimator direct : {direct_lights, direct_hemisphere}) {
      const RunningRgb samples = repeat(direct, scene, point, 1000);
      EXPECT_EQ(samples.r.mean, 0);
      EXPECT_EQ(samples.r.squares, 0);
    }
  }
}

// A large sheet ends in a straight edge. From the receiver, it cuts the light along the plane
// through this edge, and the visible rest is a polygon again.
TEST(RectangleLight, is_hidden_in_part_by_a_sheet) {
  const Rectangle& r = kRectangles[0];
  const Place place = askew();
  for (const double edge : {-0.3, -0.1, 0.0, 0.15, 0.3}) {
    SceneBuilder builder;
    add_receiver(builder, place);
    add_light(builder, place, r, false);
    // The sheet hangs at half the height, so it hides the light up to twice as far away.
    builder.quad(place.point({edge - 9, -9, 1}), place.direction({9, 0, 0}),
                 place.direction({0, 18, 0}), builder.material(gray(0.5)));
    const Polygon seen = clipped(parallelogram(r.center, r.u, r.v), {}, {1, 0, -edge});
    const Rgb truth = reflected(irradiance(place, seen));
    for (const Engine engine : kEngines) {
      const Scene scene = builder.finish(engine);
      const SurfacePoint point = receiver(scene, place);
      const std::string what = "edge at " + std::to_string(edge);
      const RunningRgb samples = repeat(direct_lights, scene, point, 20000);
      expect_mean(samples, truth, what);
      expect_mean(repeat(direct_hemisphere, scene, point, 40000), truth, what + ", hemisphere");
      if (edge == -0.3) {
        EXPECT_GT(samples.r.mean, 0);
      }
      if (edge == 0.3) {
        EXPECT_EQ(samples.r.mean, 0);
      }
    }
  }
}

// A surface behind the light, next to it or below the receiver hides nothing.
TEST(RectangleLight, is_not_hidden_by_what_is_elsewhere) {
  const Rectangle& r = kRectangles[0];
  const Place place = askew();
  SceneBuilder builder;
  add_receiver(builder, place);
  add_light(builder, place, r, false);
  const int gray_sheet = builder.material(gray(0.5));
  for (const double height : {2.001, 3.0, -0.001}) {
    builder.quad(place.point({-9, -9, height}), place.direction({18, 0, 0}),
                 place.direction({0, 18, 0}), gray_sheet);
  }
  builder.sphere(place.point({2, 0, 1}), 1, gray_sheet);
  const Rgb truth = reflected(irradiance(place, parallelogram(r.center, r.u, r.v)));
  for (const Engine engine : kEngines) {
    const Scene scene = builder.finish(engine);
    const SurfacePoint point = receiver(scene, place);
    expect_mean(repeat(direct_lights, scene, point, 20000), truth, "lights");
    expect_mean(repeat(direct_hemisphere, scene, point, 40000), truth, "hemisphere");
  }
}

TEST(SphereLight, matches_the_closed_form_near_and_far_at_every_tilt) {
  const Place place = askew();
  for (const double distance : {1.02, 1.5, 3.0, 100.0, 1e7}) {
    for (const double tilt_deg : {0.0, 30.0, 60.0, 80.0, 95.0}) {
      const double tilt = tilt_deg * kPi / 180;
      const double radius = 0.5;
      const Vec3 to_light = place.direction({std::sin(tilt), 0, std::cos(tilt)});
      const Vec3 center = place.origin + radius * distance * to_light;
      SceneBuilder builder;
      // The light is small, so that it stays out of a sphere that its plane cuts.
      const double half = 0.001;
      builder.quad(place.point({-half, -0.8 * half, 0}), place.direction({2 * half, 0, 0}),
                   place.direction({0, 2 * half, 0}), builder.material(kAlbedo));
      builder.sphere(center, radius, builder.material(gray(0), kRadiance));
      builder.light(SphereLight{center, radius, kRadiance});
      const Rgb truth = reflected(sphere_irradiance(distance, tilt));
      const Scene scene = builder.finish(Engine::task);
      const SurfacePoint point = point_seen(scene, place.point({0, 0, 0.0001}), place.origin);
      const std::string what =
          "distance " + std::to_string(distance) + ", tilt " + std::to_string(tilt_deg);
      expect_mean(repeat(direct_lights, scene, point, 20000), truth, what);
      if (distance > 3) continue;
      expect_mean(repeat(direct_hemisphere, scene, point, 40000), truth, what + ", hemisphere");
    }
  }
}

TEST(SphereLight, has_no_density_but_that_of_its_solid_angle) {
  for (const long double distance : {1.01L, 2.0L, 1e3L, 1e6L, 1e9L}) {
    const SphereLight light{{static_cast<double>(distance), 0, 0}, 1, gray(1)};
    const long double sine = 1 / distance;
    const long double solid_angle =
        2 * 3.14159265358979323846264338L * sine * sine / (1 + std::sqrt(1 - sine * sine));
    Sampler sampler(33);
    for (int i = 0; i < 1000; ++i) {
      expect_exact(1 / sample_light(light, {}, sampler).pdf, static_cast<double>(solid_angle),
                   "distance " + std::to_string(static_cast<double>(distance)));
    }
  }
}

// The contributions of the lights add up, for any number, kinds and samples of lights.
TEST(DirectLights, adds_the_lights_up) {
  const Place place = askew();
  for (const int samples : {1, 3}) {
    SceneBuilder builder;
    add_receiver(builder, place);
    double sum = 0;
    for (const int i : {0, 3, 4}) {
      const Rectangle& r = kRectangles[i];
      // The lights have no surfaces, because these would hide each other.
      builder.light(
          RectangleLight{place.point(r.center), place.direction(r.u), place.direction(r.v),
                         normalize(cross(place.direction(r.u), place.direction(r.v))), kRadiance});
      sum += irradiance(place, parallelogram(r.center, r.u, r.v));
    }
    builder.light(PointLight{place.point({0, 0, 2}), kRadiance});
    builder.light(DirectionalLight{place.direction({0, 0, -1}), kRadiance});
    const Scene scene = builder.finish(Engine::linear);
    expect_mean(repeat(direct_lights, scene, receiver(scene, place), 60000, samples),
                reflected(sum + 0.25 + 1), std::to_string(samples) + " samples");
  }
}

}  // namespace
}  // namespace pt::proof
