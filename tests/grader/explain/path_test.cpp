// Records of paths, as right and as wrong calls leave them. The room is a glowing ball, so that every ray meets a wall.
#include "grader/explain/explain.h"
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"

#include <functional>

#include <gtest/gtest.h>

namespace grader::explain {
namespace {

using pt::PathSettings;
using pt::Rgb;
using pt::Vec3;

struct World {
  pt::Scene scene;
  pt::SurfacePoint point;
  PathSettings settings{.light_samples = 2, .survival = 0.6, .from = 0, .to = 6};

  World() {
    scene.primitives.spheres = {{{0, 0, 0}, 2}};
    scene.material_of = {0};
    scene.materials = {{"", {0.9, 0.8, 0.7}, {}, ""}};
    scene.lights = {pt::AmbientLight{{1, 1, 1}}};
    scene.tracer = pt::Tracer(pt::Engine::linear, scene.primitives);
    const pt::Ray ray{{0, 0, 0}, {0, -1, 0}, 0, pt::kInfinity};
    point = surface_point(scene, ray, *scene.tracer.closest(scene.primitives, ray));
  }
};

// The faults of a path.
struct Wrong {
  int lost_direct = 0;       // no direct light at this point
  int twice_direct = 0;      // direct light twice at this point
  int samples = 2;           // of direct light
  bool by_lights = true;     // the estimator of direct light
  int ends_at = 0;           // this point, without a number
  double threshold = 0;      // the path ends where the throughput is below it, after the number
  bool on_a_copy = false;    // of the sampler
  bool new_sampler = false;  // for direct light
  bool turns_rays = false;   // the ray is not along the direction
  double factor = 1;         // of the result
  bool never_ends = false;   // whatever the number is
};

// One path by the method of the contract. It keeps its own record.
Told path(const World& w, const Wrong& wrong, std::uint64_t seed) {
  pt::Sampler given(seed);
  Told told{{}, given.state(), {}, {}};
  pt::Sampler own = given;
  pt::Sampler& sampler = wrong.on_a_copy ? own : given;
  Rgb throughput = pt::gray(1);
  pt::SurfacePoint point = w.point;
  const auto direct = [&] {
    pt::Sampler other(seed + 99);
    pt::Sampler& from = wrong.new_sampler ? other : sampler;
    const State before = from.state();
    const Rgb light = pt::gray(1 + from.next_1d());
    told.events.emplace_back(
        DirectLight{wrong.by_lights, point, wrong.samples, before, from.state(), light});
    told.result += throughput * light * wrong.factor;
  };
  for (int bounce = 1; bounce <= w.settings.to; ++bounce) {
    const bool is_wanted = bounce >= w.settings.from;
    if (is_wanted && bounce != wrong.lost_direct) direct();
    if (is_wanted && bounce == wrong.twice_direct) direct();
    if (bounce == w.settings.to || bounce == wrong.ends_at) break;
    if (bounce > 1) {
      if (!(sampler.next_1d() < w.settings.survival) && !wrong.never_ends) break;
      if (max_channel(throughput) < wrong.threshold) break;
      throughput /= w.settings.survival;
    }
    const Vec3 wo = point.frame.to_local(point.wo);
    const State before = sampler.state();
    const Vec3 wi = pt::cosine_hemisphere(sampler.next_2d());
    const pt::BsdfSample next{wi, point.albedo / pt::kPi, wi.z / pt::kPi};
    told.events.emplace_back(Direction{point.albedo, wo, before, sampler.state(), next});
    throughput *= next.f * (wi.z / next.pdf);
    const Vec3 way = wrong.turns_rays ? Vec3{-wi.x, -wi.y, wi.z} : wi;
    const pt::Ray ray = spawn_ray(point, point.frame.to_world(way));
    const auto hit = w.scene.tracer.closest(w.scene.primitives, ray);
    told.events.emplace_back(TracedRay{ray, hit});
    if (!hit) break;
    point = surface_point(w.scene, ray, *hit);
  }
  told.after = given.state();
  return told;
}

Explanation of_path(const Wrong& wrong, std::uint64_t seed = 3, const World& w = {}) {
  return explain_path(w.scene, w.scene.tracer, w.point, w.settings, path(w, wrong, seed));
}

// The first fault of many paths.
Explanation first_fault(const Wrong& wrong, const World& w = {}) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Explanation found = of_path(wrong, seed, w);
    if (found.fault != Fault::none) return found;
  }
  return {};
}

TEST(explain_path, right_paths_are_explained) {
  EXPECT_EQ(first_fault({}).got, "");
  World world;
  world.settings = {.light_samples = 2, .survival = 1, .from = 3, .to = 40};
  EXPECT_EQ(first_fault({}, world).got, "");
}

TEST(explain_path, a_dark_point_may_end_a_path) {
  World world;
  world.scene.materials[0].albedo = {};
  world.point.albedo = {};
  EXPECT_EQ(first_fault({.ends_at = 1}, world).got, "");
}

TEST(explain_path, no_direct_light_is_asked_for_without_lights) {
  World world;
  world.scene.lights.clear();
  EXPECT_EQ(first_fault({.lost_direct = 2}, world).got, "");
  world.settings.direct = PathSettings::Direct::hemisphere;
  EXPECT_NE(first_fault({.lost_direct = 2, .by_lights = false}, world).got, "");
}

TEST(explain_path, direct_light_is_taken_once_at_each_point) {
  EXPECT_EQ(first_fault({.lost_direct = 2}).got, "no direct light at point 2");
  EXPECT_EQ(first_fault({.lost_direct = 2}).promise, "adds_up_the_bounces_asked_for");
  EXPECT_EQ(first_fault({.twice_direct = 1}).got, "direct light twice at point 1");
}

TEST(explain_path, direct_light_is_that_of_the_settings) {
  EXPECT_EQ(first_fault({.samples = 1}).promise, "takes_the_light_samples_asked_for");
  EXPECT_EQ(first_fault({.by_lights = false}).promise, "starts_with_direct_light");
}

TEST(explain_path, only_a_number_ends_a_path) {
  const Explanation first = first_fault({.ends_at = 1});
  EXPECT_EQ(first.promise, "takes_the_first_bounce_always");
  const Explanation third = first_fault({.ends_at = 3});
  EXPECT_EQ(third.fault, Fault::structure);
  EXPECT_EQ(third.promise, "reaches_the_last_bounce");
  EXPECT_EQ(third.got, "a path that ends at point 3 of 6, and no random number says so");
}

TEST(explain_path, only_a_number_below_the_survival_lets_it_go_on) {
  const Explanation endless = first_fault({.never_ends = true});
  EXPECT_EQ(endless.fault, Fault::habit);
  EXPECT_EQ(endless.promise, "does_not_depend_on_survival");
}

TEST(explain_path, a_number_below_the_survival_lets_it_go_on) {
  const Explanation small = first_fault({.threshold = 1});
  EXPECT_EQ(small.fault, Fault::habit);
  EXPECT_EQ(small.promise, "reaches_the_last_bounce");
}

TEST(explain_path, inner_calls_share_the_sampler) {
  const Explanation copy = of_path({.on_a_copy = true});
  EXPECT_EQ(copy.promise, "draws_from_the_sampler_alone");
  EXPECT_EQ(copy.got, "a call that leaves the sampler as it was before");
  EXPECT_EQ(of_path({.new_sampler = true}).promise, "draws_from_the_sampler_alone");
}

TEST(explain_path, rays_follow_directions) {
  EXPECT_EQ(first_fault({.turns_rays = true}).promise, "follows_the_new_ray");
}

// Float has no numbers below 1e-45.
TEST(explain_path, light_that_float_does_not_have_may_be_lost) {
  World world;
  world.scene.materials[0].albedo = world.point.albedo = pt::gray(1e-3);
  world.settings = {.light_samples = 2, .survival = 1, .from = 20, .to = 20};
  EXPECT_EQ(first_fault({.factor = 0}, world).got, "");
  world.settings.from = world.settings.to = 4;
  EXPECT_EQ(of_path({.factor = 0}, 3, world).fault, Fault::value);
}

TEST(explain_path, compares_the_result) {
  const Explanation off = of_path({.factor = 1.001});
  EXPECT_EQ(off.fault, Fault::value);
  EXPECT_NEAR(off.off.g, 0.001 * off.value.g, 1e-9);
}

}  // namespace
}  // namespace grader::explain
