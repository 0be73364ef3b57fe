#include "pt/render/bounces_apart.h"

#include "pt/render/pixel_record.h"
#include "pt/render/radiance_apart.h"
#include "pt/render/render_apart.h"
#include "pt/tasks/trace_path.h"
#include "tests/proof/one_walk.h"
#include "tests/proof/statistics.h"

// One walk of trace_path, split by bounce. The parts add up to the walk, and in a closed room the
// light of bounce k is known. Every version of trace_path that is linked here is tested.

namespace pt::proof {
namespace {

// A closed room of one material.
Scene room(Rgb albedo, Rgb emission) {
  SceneBuilder builder;
  builder.room({-1, -0.5, -2}, {1, 1, 1.5}, builder.material(albedo, emission));
  builder.light(mesh_light(builder.triangles(), emission));
  return builder.finish(Engine::task);
}

void expect_close(Rgb a, Rgb b, double relative, const std::string& what) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a[i], b[i], relative * (std::abs(a[i]) + std::abs(b[i]))) << what;
  }
}

TEST(BouncesApart, add_up_to_the_walk_and_leave_the_sampler_where_it_left_it) {
  const Scene scene = yard();
  const SurfacePoint point = point_seen(scene, {1, 3, 6}, {1, 0, 1});
  for (const Direct direct : {Direct::lights, Direct::hemisphere}) {
    const PathSettings settings = settings_up_to(40, direct);
    Sampler one(3), other(3);
    for (int i = 0; i < 3000; ++i) {
      const Rgb alone = trace_path(scene, point, settings, one);
      const BouncesApart apart = trace_path_apart(scene, point, settings, kPieces, other);
      ASSERT_EQ(apart.sum, alone);
      ASSERT_TRUE(apart.complete);
      ASSERT_EQ(one.state(), other.state());
      expect_close(sum_of(apart, kPieces.size()), alone, 1e-6, "sum");
    }
  }
}

TEST(BouncesApart, cost_no_more_rays_than_the_walk) {
  const Scene scene = yard();
  const SurfacePoint point = point_seen(scene, {1, 3, 6}, {1, 0, 1});
  const PathSettings settings = settings_up_to(40, Direct::lights);
  Sampler one(5), other(5);
  const RayCount start = rays_traced();
  for (int i = 0; i < 500; ++i) trace_path(scene, point, settings, one);
  const RayCount middle = rays_traced();
  for (int i = 0; i < 500; ++i) trace_path_apart(scene, point, settings, kPieces, other);
  const RayCount end = rays_traced();
  EXPECT_EQ(end.closest - middle.closest, middle.closest - start.closest);
  EXPECT_EQ(end.occluded - middle.occluded, middle.occluded - start.occluded);
}

// The walk of one bounce ends after the light of that bounce. Its part is that of the whole walk, bit for bit.
TEST(BouncesApart, of_one_bounce_are_those_of_the_whole_walk) {
  const Scene scene = yard();
  const SurfacePoint point = point_seen(scene, {1, 3, 6}, {1, 0, 1});
  const PathSettings settings = settings_up_to(40, Direct::lights);
  std::vector<BounceRange> bounces;
  for (int k = 1; k <= settings.to; ++k) bounces.push_back({k, k});
  Sampler one(6), other(6);
  std::size_t seen = 0;
  for (int i = 0; i < 5000; ++i) {
    const BouncesApart apart = trace_path_apart(scene, point, settings, bounces, one);
    std::vector<Rgb> whole = trace_path_in_parts(scene, point, settings, other).bounces;
    whole.resize(bounces.size());
    for (std::size_t k = 1; k < whole.size(); ++k) {
      ASSERT_EQ(apart.ranges[k], whole[k]) << "bounce " << k + 1;
      seen += whole[k] == Rgb{} ? 0 : 1;
    }
  }
  EXPECT_GT(seen, 300U);
}

// Bounce k of a closed room of emission E and albedo a has the radiance E a^k.
TEST(BouncesApart, glow_as_the_closed_form_says) {
  const Rgb albedo{0.2, 0.5, 0.65}, emission{2, 1, 0.5};
  const Scene scene = room(albedo, emission);
  const SurfacePoint point = point_seen(scene, {0.2, 0.1, 0.3}, {1, 0.4, -1});
  const PathSettings settings = settings_up_to(40, Direct::hemisphere);
  std::vector<RunningRgb> means(kPieces.size());
  Sampler sampler(7);
  for (int i = 0; i < 40000; ++i) {
    const BouncesApart apart = trace_path_apart(scene, point, settings, kPieces, sampler);
    for (std::size_t k = 0; k < means.size(); ++k) means[k].add(apart.ranges[k]);
  }
  for (std::size_t k = 0; k < means.size(); ++k) {
    Rgb truth, power = emission;
    for (int bounce = 1; bounce <= kPieces[k].to; ++bounce) {
      power *= albedo;
      if (bounce >= kPieces[k].from) truth += power;
    }
    expect_mean(means[k], truth, "bounces from " + std::to_string(kPieces[k].from));
  }
}

View view_of(const Scene& scene) {
  Camera camera;
  camera.position = {0, 2, 8};
  return {scene, camera, settings_up_to(40, Direct::lights), 12, 9};
}

TEST(PixelApart, has_the_mean_and_variance_of_the_ordinary_pixel_in_the_whole_range) {
  const Scene scene = yard();
  const View view = view_of(scene);
  const std::vector<BounceRange> ranges{{0, 40}, {0, 0}, {0, 1}, {2, 40}};
  for (int x = 0; x < view.width; ++x) {
    const FilmPixel pixel = render_pixel(view, x, 3, {16, {}, 4, 1}).pixel;
    const PixelApart apart = render_pixel_apart(view, x, 3, {16, {}, 4, 1}, ranges);
    ASSERT_TRUE(apart.complete);
    expect_close(apart.pixels[0].mean, pixel.mean, 1e-6, "mean");
    EXPECT_NEAR(apart.pixels[0].variance_y, pixel.variance_y, 1e-6 * pixel.variance_y);
    EXPECT_EQ(apart.pixels[0].samples, pixel.samples);
    expect_close(apart.pixels[2].mean + apart.pixels[3].mean, pixel.mean, 1e-6, "two parts");
    EXPECT_EQ(apart.pixels[1].mean, Rgb{});  // nothing here emits
  }
}

TEST(PixelApart, is_cut_where_a_range_begins_or_ends) {
  const std::vector<BounceRange> ranges{{0, 3}, {2, 100}, {0, 0}};
  const std::vector<BounceRange> pieces{{1, 1}, {2, 3}, {4, 100}};
  EXPECT_EQ(pieces_of(ranges), pieces);
  EXPECT_TRUE(pieces_of(std::vector<BounceRange>{{0, 0}}).empty());
}

}  // namespace
}  // namespace pt::proof
