// Hemisphere sampling and light sampling estimate the same light, in scenes without a closed form.
// Both engines agree too, and pictures with any survival probability.
#include "pt/math/rgb.h"
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "tests/proof/scenes.h"
#include "tests/proof/statistics.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pt::proof {
namespace {

// Compares two pictures of one scene by a z for each pixel, each block and each sum over the
// picture. It uses the larger of the two variances, so that too few or too many bright samples in
// one picture are not taken for an error. No margin is added, because both pictures are right or
// one is wrong. The level is divided by the number of comparisons (Bonferroni).

// One channel or the luminance: mean and variance of each pixel's samples.
struct Plane {
  int width = 0, height = 0;
  std::vector<Running> pixels;

  Plane(int width_, int height_) : width(width_), height(height_), pixels(width_ * height_) {}
};

struct Picture {
  Plane luminance, r, g, b;

  Picture(int width, int height)
      : luminance(width, height), r(width, height), g(width, height), b(width, height) {}

  void add(int pixel, Rgb value) {
    luminance.pixels[pixel].add(pt::luminance(value));
    r.pixels[pixel].add(value.r);
    g.pixels[pixel].add(value.g);
    b.pixels[pixel].add(value.b);
  }
};

struct Worst {
  double z = 0;
  int comparisons = 0;

  void add(double other) {
    if (!(std::abs(other) <= std::abs(z))) z = other;  // also if z is NaN
    ++comparisons;
  }
};

// Returns z of the weighted difference. Pixels without variance are left out.
double z_of(const Plane& a, const Plane& golden, const std::vector<double>& weights) {
  double difference = 0, own = 0, expected = 0, of_golden = 0;
  for (std::size_t p = 0; p < weights.size(); ++p) {
    const Running &x = a.pixels[p], &g = golden.pixels[p];
    const double w = weights[p], n = static_cast<double>(x.n);
    difference += w * (x.mean - g.mean);
    own += w * w * x.variance() / n;
    expected += w * w * g.variance() / n;
    of_golden += w * w * g.variance() / static_cast<double>(g.n);
  }
  const double variance = std::max(own, expected) + of_golden;
  return variance > 0 ? difference / std::sqrt(variance) : difference == 0 ? 0 : HUGE_VAL;
}

void add_blocks(const Plane& a, const Plane& golden, int size, Worst& worst) {
  for (int y = 0; y < a.height; y += size) {
    for (int x = 0; x < a.width; x += size) {
      std::vector<double> weights(a.pixels.size());
      for (int j = y; j < std::min(y + size, a.height); ++j) {
        for (int i = x; i < std::min(x + size, a.width); ++i) weights[j * a.width + i] = 1;
      }
      worst.add(z_of(a, golden, weights));
    }
  }
}

// The plain mean, and a mean with larger weights for quiet pixels: w = g / (v + median(v) / 20).
void add_sums(const Plane& a, const Plane& golden, Worst& worst) {
  std::vector<double> variances, weights;
  for (const Running& pixel : golden.pixels) variances.push_back(pixel.variance());
  std::nth_element(variances.begin(), variances.begin() + variances.size() / 2, variances.end());
  const double median = variances[variances.size() / 2];
  for (const Running& pixel : golden.pixels) {
    weights.push_back(pixel.mean / (pixel.variance() + 0.05 * median));
  }
  worst.add(z_of(a, golden, weights));
  worst.add(z_of(a, golden, std::vector<double>(a.pixels.size(), 1)));
}

void expect_same_picture(const Picture& a, const Picture& golden, const std::string& what) {
  Worst worst;
  for (const int size : {1, 4, 8}) add_blocks(a.luminance, golden.luminance, size, worst);
  for (const auto channel : {&Picture::luminance, &Picture::r, &Picture::g, &Picture::b}) {
    add_blocks(a.*channel, golden.*channel, 24, worst);
    add_sums(a.*channel, golden.*channel, worst);
  }
  EXPECT_LE(std::abs(worst.z), two_sided_threshold(kLevel / worst.comparisons))
      << what << ", of " << worst.comparisons << " comparisons";
}

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
