#include "grader/mistakes/battery.h"

#include "grader/check/language/repeat.h"
#include "grader/mistakes/patches.h"
#include "grader/tasks/direct_hemisphere/inputs.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;
using namespace direct_hemisphere_inputs;

using pt::Vec3;

void ask(Battery& battery, const Situation& s, int samples = 1, int draws = 4000) {
  battery.estimate(draws, [&](int n, std::uint64_t seed) {
    return repeat<pt::direct_hemisphere>(n, seed, s.scene, s.point, samples);
  });
}

void ask(Battery& battery, const SceneMaker& maker, int samples = 1, int draws = 4000) {
  ask(battery, maker.done(), samples, draws);
}

// Returns a patch that glows itself.
SceneMaker glowing_patch(bool from_behind = false) { return patch(here(), from_behind, {5, 4, 3}); }

void skies(Battery& battery) {
  for (const Vec3 n : {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, -0.5, 1}}) {
    ask(battery, patch(turned(n)).sky(kRadiance));
  }
  ask(battery, patch(turned({0, 1, 0}), true).sky(kRadiance));
}

void lights(Battery& battery) {
  ask(battery, patch().rectangle(kAbove, kRadiance, Body::surface));
  ask(battery, patch(turned({1, 2, 3})).rectangle(kAbove, kRadiance, Body::surface));
  ask(battery, patch(turned({-1, 0.2, 0.1}), true).rectangle(kAside, kRadiance, Body::surface));
  ask(battery, patch().surface(kAbove, {0.2, 0.7, 0.4}, kRadiance));
  ask(battery, patch().surface(kAbove, {0.2, 0.7, 0.4}));
  ask(battery, patch().rectangle(kAbove, kRadiance, Body::none));
  ask(battery, patch().surface(kAbove.flipped(), {.4, .4, .4}, kRadiance));
  ask(battery, patch().rectangle(kAbove, kRadiance, Body::surface, 0.4));
  ask(battery, glowing_patch());
  ask(battery, glowing_patch().surface(kAbove, {.2, .2, .2}));
  ask(battery, glowing_patch().surface(kAbove, {.2, .2, .2}, kRadiance));
  ask(battery, patch().point_light({0, 0, 2}, kRadiance));
}

void samples(Battery& battery) {
  for (const int each : {2, 4, 16, 40}) {
    ask(battery, patch().rectangle(kAbove, kRadiance, Body::surface), each, 2000);
  }
}

// A patch inside a glowing box, far from the origin and near it, large and small.
void scales(Battery& battery) {
  for (const double size : {1e-4, 1e-2, 1e2, 1e4}) {
    for (const Vec3 shift : {Vec3{}, Vec3{100, -70, 50}}) {
      SceneMaker maker = patch(here(size, shift));
      glowing_walls(maker, kRadiance);
      ask(battery, maker.surface(cube().back(), {.3, .3, .3}), 1, 1000);
    }
    for (const Pose& pose : {here(size), far_away(size)}) {
      SceneMaker maker = patch(pose).rectangle(kAbove, kRadiance, Body::surface);
      ask(battery, maker, 1, 1000);
      ask(battery, maker.surface(kPlate, {.5, .5, .5}), 1, 1000);
    }
  }
}

// Light of any brightness and any colour, and many directions.
void brightness(Battery& battery) {
  for (const pt::Rgb radiance :
       {pt::Rgb{3e5, 2e5, 1e5}, pt::Rgb{30, 20, 40}, pt::Rgb{3e-3, 2e-3, 1e-3}, pt::Rgb{2, 0, 3}}) {
    ask(battery, patch().rectangle(kAbove, radiance, Body::surface), 1, 1000);
  }
  // The sky above a floor, where the mean has so little noise that one sample of 64 counts.
  ask(battery, patch(turned({0, 1, 0})).sky(kRadiance), 64, 2000);
  ask(battery, patch().sky(kRadiance), 3000, 60);
}

// A point that glows on its front, seen from behind. A ray that starts on the wrong side meets it; a
// direction on the wrong side brings no light.
void glowing_front(Battery& battery) { ask(battery, glowing_patch(true)); }

// A sky that is not the first light, and a sky beside a light without a surface.
void skies_beside_lights(Battery& battery) {
  const SceneMaker floor = patch(turned({0, 1, 0}));
  SceneMaker after = floor, before = floor;
  ask(battery, after.point_light({0, 0, 2}, kRadiance).sky(kRadiance), 1, 500);
  ask(battery, before.sky(kRadiance).rectangle(kAbove, kRadiance, Body::none), 1, 500);
}

// A light behind a surface that turns its back to the point. Then both sides of a light with
// reversed corner normals.
void backs(Battery& battery) {
  ask(battery,
      patch()
          .rectangle(kAbove, kRadiance, Body::surface)
          .surface(shade_of(kAbove, 0.5).flipped(), {.5, .5, .5}),
      1, 500);
  for (const Rectangle& light : {kAbove, kAbove.flipped()}) {
    const SceneMaker maker = patch().rectangle(light, kRadiance, Body::surface);
    ask(battery, with_corner_normals_turned_round(maker.done()), 1, 500);
  }
}

// The normal of the true surface is not the shading normal.
void smooth_shading(Battery& battery) {
  Situation s =
      SceneMaker(here()).rectangle(kAside, kRadiance, Body::surface).point(kAlbedo, kTilted).done();
  s.point.geometric_normal = normalize(Vec3{-0.3, -0.1, 0.9});
  ask(battery, s);
}

// A light a million units away, a ball, and a lamp that fills a hundred-and-fiftieth of the
// hemisphere, so that a hundred directions may miss it.
void sizes_and_shapes(Battery& battery) {
  ask(battery,
      SceneMaker(here(1e6)).rectangle(kAbove, kRadiance, Body::surface).point(kAlbedo, kTilted), 1,
      500);
  ask(battery, patch().ball({0, 0, 2}, 1, kRadiance, Body::surface), 1, 500);
  const Rectangle small{{0, 0, 1}, {0, 0.2, 0}, {0.2, 0, 0}};
  ask(battery, patch().rectangle(small, kRadiance, Body::surface), 400, 80);
}

// Glowing strips that stand upright between the whole degrees of the azimuth.
void strips_between_degrees(Battery& battery) {
  constexpr int kStrips = 40;
  constexpr double kDegree = pt::kPi / 180;
  SceneMaker maker = patch();
  for (int i = 0; i < kStrips; ++i) {
    const double azimuth = (360.0 / kStrips * i + 0.5) * kDegree;
    maker.surface(upright_strip(azimuth, 0.8 * kDegree), {.5, .5, .5}, kRadiance);
  }
  ask(battery, maker, 1, 1500);
}

// Four walls that glow in red up to 0.05 degrees above the horizon, and in green from 0.06 to 0.16
// degrees.
void lit_at_the_horizon(Battery& battery) {
  SceneMaker maker(here());
  for (const Rectangle& strip : strips_of_walls(0, 9e-4)) {
    maker.surface(strip, {.5, .5, .5}, {1e6, 0, 0});
  }
  for (const Rectangle& strip : strips_of_walls(1.5e-3, 2.8e-3)) {
    maker.surface(strip, {.5, .5, .5}, {0, 1e6, 0});
  }
  ask(battery, maker.patch(pt::gray(0.5), kTilted), 50, 1000);
}

// A patch in a large room that glows. A ray must not meet the patch again.
void far_from_the_origin(Battery& battery) {
  for (const Pose& pose : farthest(1e6)) {
    SceneMaker maker = patch(pose);
    glowing_walls(maker, kRadiance);
    ask(battery, maker, 1, 200);
  }
}

// Light is never negative.
void signs(Battery& battery) {
  const Situation s = patch().sky(kRadiance).done();
  battery.mean(200, [&](int n, std::uint64_t seed) {
    std::vector<Battery::Numbers> negative;
    for (const pt::Rgb each : repeat<pt::direct_hemisphere>(n, seed, s.scene, s.point, 1)) {
      negative.push_back({flag(luminance(each) < 0)});
    }
    return negative;
  });
}

void sampler(Battery& battery, const Rectangle& lamp) {
  const Situation s = patch().rectangle(lamp, kRadiance, Body::surface).done();
  battery.ask([&] {
    return use_of_sampler([&](pt::Sampler& sampler) {
      return numbers(pt::direct_hemisphere(s.scene, s.point, 4, sampler));
    });
  });
}

}  // namespace

void run_battery(Battery& battery) {
  skies(battery);
  lights(battery);
  samples(battery);
  scales(battery);
  brightness(battery);
  sampler(battery, kAbove);
  glowing_front(battery);
  skies_beside_lights(battery);
  backs(battery);
  smooth_shading(battery);
  sizes_and_shapes(battery);
  strips_between_degrees(battery);
  lit_at_the_horizon(battery);
  far_from_the_origin(battery);
  signs(battery);
  sampler(battery, kAbove.scaled(-1));  // below the horizon: no light is found
}

}  // namespace grader::mistakes
