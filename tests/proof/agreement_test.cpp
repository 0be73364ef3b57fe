#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "tests/proof/image_verdict.h"
#include "tests/proof/scenes.h"

// Hemisphere sampling and light sampling estimate the same light, in scenes without a closed form.
// Both engines agree too, and pictures with any survival probability.

namespace pt::proof {
namespace {

using Direct = PathSettings::Direct;

constexpr int kWidth = 24, kHeight = 18;

// A room with a lamp below its ceiling, a glowing ball, a glowing tetrahedron, and a ball and a
// block that cast shadows. The lamps are large, so that hemisphere sampling finds them.
SceneBuilder room() {
  SceneBuilder builder;
  builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({0.7, 0.5, 0.3}));
  const int diffuse = builder.material({0.3, 0.5, 0.7});
  builder.sphere({-0.5, -0.6, -0.2}, 0.4, diffuse);
  builder.quad({0.2, -0.4, -0.6}, {0.5, 0, 0.1}, {0, 0.1, 0.5}, diffuse);
  builder.quad({0.2, -0.4, -0.6}, {0.1, -0.6, 0}, {0.5, 0, 0.1}, diffuse);

  const Rgb lamp{2, 3, 4}, ball{6, 4, 2}, glow{1, 1, 5};
  builder.quad({-0.6, 0.8, -0.6}, {1.2, 0, 0}, {0, 0, 1.2}, builder.material(gray(0.2), lamp));
  builder.light(RectangleLight{{0, 0.8, 0}, {1.2, 0, 0}, {0, 0, 1.2}, {0, -1, 0}, lamp});
  builder.sphere({0.55, 0.1, -0.5}, 0.25, builder.material(gray(0.2), ball));
  builder.light(SphereLight{{0.55, 0.1, -0.5}, 0.25, ball});

  const Vec3 a{-0.9, -0.2, -0.8}, b{-0.4, -0.1, -0.9}, c{-0.7, 0.4, -0.8}, d{-0.6, 0, -0.4};
  SceneBuilder mesh;
  const int unused = mesh.material({});
  mesh.triangle(a, c, b, unused);
  mesh.triangle(a, b, d, unused);
  mesh.triangle(b, c, d, unused);
  mesh.triangle(c, a, d, unused);
  const int glowing = builder.material(gray(0.2), glow);
  for (const Triangle& t : mesh.triangles()) builder.triangle(t.p0, t.p1, t.p2, glowing);
  builder.light(mesh_light(mesh.triangles(), glow));
  return builder;
}

View view_of(const Scene& scene) {
  View view{scene, {}, {}, kWidth, kHeight};
  view.camera.position = {0.1, 0.05, 0.95};
  view.camera.hfov_deg = 80;
  view.camera.vfov_deg = 64;
  return view;
}

Picture render(const View& view, int samples, std::uint64_t seed) {
  Picture picture(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      Sampler sampler = Sampler::for_pixel(seed, x, y);
      for (int i = 0; i < samples; ++i) {
        const Vec2 xi = sampler.next_2d();
        const Ray ray = camera_ray(view.camera, (x + xi.x) / kWidth, (y + xi.y) / kHeight);
        picture.add(y * kWidth + x, radiance(view.scene, ray, view.settings, sampler));
      }
    }
  }
  return picture;
}

TEST(Agreement, of_hemisphere_and_lights_in_direct_light) {
  const Scene scene = room().finish(Engine::task);
  View view = view_of(scene);
  view.settings.from = view.settings.to = 1;
  const Picture lights = render(view, 300, 101);
  view.settings.direct = Direct::hemisphere;
  view.settings.light_samples = 4;
  expect_same_picture(lights, render(view, 500, 102), "direct light");
}

TEST(Agreement, of_hemisphere_and_lights_over_all_bounces) {
  const Scene scene = room().finish(Engine::task);
  View view = view_of(scene);
  view.settings.to = 4;
  const Picture lights = render(view, 200, 103);
  view.settings.direct = Direct::hemisphere;
  view.settings.light_samples = 4;
  expect_same_picture(lights, render(view, 250, 104), "all bounces");
}

TEST(Agreement, of_different_survival) {
  const Scene scene = room().finish(Engine::task);
  View view = view_of(scene);
  view.settings.to = 6;
  const Picture often = render(view, 200, 105);
  view.settings.survival = 1;
  expect_same_picture(often, render(view, 150, 106), "survival");
}

// The same random numbers and the same surfaces give the same picture, except for ties that no ray
// decides.
TEST(Agreement, of_both_engines_to_the_last_bit) {
  const Scene linear = room().finish(Engine::linear), task = room().finish(Engine::task);
  View a = view_of(linear), b = view_of(task);
  a.settings.to = b.settings.to = 4;
  const Picture one = render(a, 10, 107), other = render(b, 10, 107);
  for (int p = 0; p < kWidth * kHeight; ++p) {
    EXPECT_EQ(one.luminance.pixels[p].mean, other.luminance.pixels[p].mean) << p;
  }
}

// At single points, with the errors of many more samples.
TEST(Agreement, of_both_ways_at_points) {
  const Scene scene = room().finish(Engine::task);
  for (const Vec3 target : {Vec3{0.1, -1, 0.2}, Vec3{-0.5, -0.3, -0.2}, Vec3{-0.3, 0.2, -1},
                            Vec3{1, 0.3, 0.1}, Vec3{0.3, -1, -0.5}}) {
    const SurfacePoint point = point_seen(scene, {0.1, 0.05, 0.95}, target);
    Sampler sampler(108);
    RunningRgb lights, hemisphere;
    for (int i = 0; i < 20000; ++i) lights.add(direct_lights(scene, point, 2, sampler));
    for (int i = 0; i < 60000; ++i) hemisphere.add(direct_hemisphere(scene, point, 2, sampler));
    for (const auto channel : {&RunningRgb::r, &RunningRgb::g, &RunningRgb::b}) {
      const Running &a = lights.*channel, &b = hemisphere.*channel;
      EXPECT_LE(std::abs(a.mean - b.mean),
                two_sided_threshold(kLevel) * std::hypot(a.standard_error(), b.standard_error()));
    }
  }
}

}  // namespace
}  // namespace pt::proof
