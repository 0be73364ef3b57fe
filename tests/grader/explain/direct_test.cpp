// Records of direct light, as right and as wrong calls leave them.
#include "grader/explain/explain.h"
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"

#include <functional>

#include <gtest/gtest.h>

namespace grader::explain {
namespace {

using pt::Rgb;
using pt::Vec3;

constexpr int kSamples = 16;

// A floor under a glowing wall and a sky, seen from above.
struct World {
  pt::Scene scene;
  pt::SurfacePoint point;

  World() {
    scene.primitives.triangles = {pt::flat_triangle({-1, 0, -1}, {-1, 0, 1}, {1, 0, 0}),
                                  pt::flat_triangle({-9, 2, -9}, {9, 2, -9}, {0, 2, 0})};
    scene.material_of = {0, 1};
    scene.materials = {{"", pt::gray(0.5), {}, ""}, {"", pt::gray(0.2), {3, 2, 1}, ""}};
    scene.lights = {pt::RectangleLight{{0, 3, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {5, 4, 3}},
                    pt::PointLight{{1, 1, 0}, {2, 2, 2}}, pt::AmbientLight{{0.1, 0.2, 0.3}}};
    scene.tracer = pt::Tracer(pt::Engine::linear, scene.primitives);
    const pt::Ray ray{{0, 1, 0.1}, {0, -1, 0}, 0, pt::kInfinity};
    point = surface_point(scene, ray, *scene.tracer.closest(scene.primitives, ray));
  }
};

using Task = std::function<Rgb(const World&, pt::Sampler&)>;

Told told(const World& world, const Task& task) {
  return record_one(world.scene, 7, 0, [&](pt::Sampler& sampler) { return task(world, sampler); });
}

Rgb by_direction(const World& w, Vec3 wi) {
  const pt::Ray ray = spawn_ray(w.point, wi);
  const auto hit = w.scene.closest(ray);
  return w.point.albedo *
         (hit ? surface_point(w.scene, ray, *hit).emission : background(w.scene, wi)) *
         (2 * dot(w.point.n, wi));
}

Rgb hemisphere(const World& w, pt::Sampler& sampler, int count, double from = 0) {
  Rgb sum;
  for (int i = 0; i < count; ++i) {
    const Vec3 local = pt::uniform_hemisphere(sampler.next_2d());
    if (local.z >= from) sum += by_direction(w, w.point.frame.to_world(local));
  }
  return sum / count;
}

Explanation of_hemisphere(const Task& task) {
  const World world;
  return explain_hemisphere(world.scene, world.scene.tracer, world.point, kSamples,
                            told(world, task));
}

TEST(explain_hemisphere, right_calls_are_explained) {
  EXPECT_EQ(of_hemisphere([](const World& w, pt::Sampler& s) {
              return hemisphere(w, s, kSamples);
            }).fault,
            Fault::none);
  const auto cosine = of_hemisphere([](const World& w, pt::Sampler& s) {
    Rgb sum;
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 local = pt::cosine_hemisphere(s.next_2d());
      sum += by_direction(w, w.point.frame.to_world(local)) / (2 * local.z);
    }
    return sum / kSamples;
  });
  EXPECT_EQ(cosine.fault, Fault::none);
}

TEST(explain_hemisphere, a_record_is_answered_as_the_scene_answers) {
  const World world;
  Told call =
      told(world, [](const World& w, pt::Sampler& s) { return hemisphere(w, s, kSamples); });
  for (Event& event : call.events) std::get<TracedRay>(event).hit.reset();
  answer(world.scene, {}, call.events);
  EXPECT_EQ(explain_hemisphere(world.scene, world.scene.tracer, world.point, kSamples, call).fault,
            Fault::none);
}

TEST(explain_hemisphere, counts_rays) {
  const Explanation few =
      of_hemisphere([](const World& w, pt::Sampler& s) { return hemisphere(w, s, kSamples - 1); });
  EXPECT_EQ(few.fault, Fault::structure);
  EXPECT_EQ(few.promise, "takes_the_samples_asked_for");
  EXPECT_EQ(few.got, "15 rays of 16 samples");
  EXPECT_EQ(of_hemisphere([](const World& w, pt::Sampler& s) {
              return hemisphere(w, s, kSamples, 0.3);
            }).promise,
            "takes_the_samples_asked_for");
}

TEST(explain_hemisphere, no_ray_is_needed_where_nothing_glows) {
  World world;
  world.scene.materials[1].emission = {};
  world.scene.lights.pop_back();
  const Told none = told(world, [](const World&, pt::Sampler&) { return Rgb{}; });
  EXPECT_EQ(explain_hemisphere(world.scene, world.scene.tracer, world.point, kSamples, none).fault,
            Fault::none);
}

TEST(explain_hemisphere, sees_a_sampler_that_stands) {
  const Explanation copy = of_hemisphere([](const World& w, pt::Sampler& s) {
    pt::Sampler own = s;
    return hemisphere(w, own, kSamples);
  });
  EXPECT_EQ(copy.fault, Fault::structure);
  EXPECT_EQ(copy.promise, "draws_from_the_sampler_alone");
}

TEST(explain_hemisphere, compares_the_result) {
  const Explanation off = of_hemisphere(
      [](const World& w, pt::Sampler& s) { return 1.001 * hemisphere(w, s, kSamples); });
  EXPECT_EQ(off.fault, Fault::value);
  EXPECT_NEAR(off.off.r, 0.001 * off.value.r, 1e-9);
  EXPECT_GT(off.value.r, 0);
}

Rgb by_lights(const World& w, pt::Sampler& sampler, int count, int first = 0, int end = 3) {
  Rgb sum;
  for (int k = first; k < std::min(end, static_cast<int>(w.scene.lights.size())); ++k) {
    const int draws = is_delta(w.scene.lights[k]) ? 1 : count;
    for (int i = 0; i < draws; ++i) {
      const pt::LightSample s = sample_light(w.scene.lights[k], w.point.p, sampler);
      const double cosine = dot(w.point.n, s.wi);
      if (!(cosine > 0) || w.scene.occluded(shadow_ray(w.point, s.wi, s.distance))) continue;
      sum += w.point.albedo / pt::kPi * s.radiance * (cosine / s.pdf) / draws;
    }
  }
  return sum;
}

Explanation of_lights(const Task& task, const World& world = {}) {
  return explain_lights(world.scene, world.scene.tracer, world.point, kSamples, told(world, task));
}

TEST(explain_lights, right_calls_are_explained) {
  EXPECT_EQ(
      of_lights([](const World& w, pt::Sampler& s) { return by_lights(w, s, kSamples); }).fault,
      Fault::none);
  // A light below the horizon brings nothing, and need not be drawn.
  World world;
  std::get<pt::RectangleLight>(world.scene.lights[0]).center = {0, -3, 0};
  EXPECT_EQ(
      of_lights([](const World& w, pt::Sampler& s) { return by_lights(w, s, kSamples, 1); }, world)
          .fault,
      Fault::none);
}

TEST(explain_lights, counts_draws) {
  const Explanation one =
      of_lights([](const World& w, pt::Sampler& s) { return by_lights(w, s, 1); });
  EXPECT_EQ(one.fault, Fault::structure);
  EXPECT_EQ(one.promise, "takes_the_samples_asked_for");
  EXPECT_EQ(one.got, "1 draw of light 1 (a rectangle) for 16 samples");
  const Explanation none =
      of_lights([](const World& w, pt::Sampler& s) { return by_lights(w, s, kSamples, 2); });
  EXPECT_EQ(none.got, "0 draws of light 1 (a rectangle) for 16 samples");
}

TEST(explain_lights, sees_a_sampler_that_stands) {
  const Explanation copy = of_lights([](const World& w, pt::Sampler& s) {
    pt::Sampler own = s;
    return by_lights(w, own, kSamples);
  });
  EXPECT_EQ(copy.promise, "draws_from_the_sampler_alone");
}

TEST(explain_lights, sees_numbers_that_are_used_twice) {
  const Explanation again = of_lights([](const World& w, pt::Sampler& s) {
    const pt::Sampler start = s;
    const Rgb sum = by_lights(w, s, kSamples, 2);
    s = start;
    return sum + by_lights(w, s, kSamples, 0, 2);
  });
  EXPECT_EQ(again.promise, "draws_from_the_sampler_alone");
}

// A task may draw numbers of its own.
TEST(explain_lights, numbers_in_between_are_explained) {
  const Explanation own = of_lights([](const World& w, pt::Sampler& s) {
    for (int i = 0; i < 1000; ++i) s.next_1d();
    const Rgb sum = by_lights(w, s, kSamples);
    s.next_1d();
    return sum;
  });
  EXPECT_EQ(own.got, "");
}

TEST(explain_lights, compares_the_result) {
  const auto off = [](const World& w, pt::Sampler& s) { return 1.01 * by_lights(w, s, kSamples); };
  EXPECT_EQ(of_lights(off).fault, Fault::value);
  EXPECT_EQ(of_lights(off).promise, "adds_the_lights_up");
  World world;
  world.scene.lights.pop_back();
  world.scene.lights.pop_back();
  EXPECT_EQ(of_lights(off, world).promise, "matches_a_rectangle");
}

TEST(explain_lights, a_light_of_the_tasks_own_is_not_explained) {
  const Explanation own = of_lights([](const World& w, pt::Sampler& s) {
    const pt::Light copy = w.scene.lights[0];
    sample_light(copy, w.point.p, s);
    return by_lights(w, s, kSamples);
  });
  EXPECT_EQ(own.fault, Fault::value);
}

// A worker may send any number.
TEST(explain_lights, a_light_that_the_scene_does_not_have_is_not_explained) {
  const World world;
  Told call = told(world, [](const World& w, pt::Sampler& s) { return by_lights(w, s, kSamples); });
  std::get<LightDraw>(call.events[0]).light = 1000000000;
  answer(world.scene, {}, call.events);
  EXPECT_EQ(explain_lights(world.scene, world.scene.tracer, world.point, kSamples, call).fault,
            Fault::value);
}

}  // namespace
}  // namespace grader::explain
