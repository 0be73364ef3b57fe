#include "pt/tasks/direct_hemisphere.h"

#include "grader/check/repeat.h"
#include "grader/mistakes/battery.h"
#include "grader/mistakes/stages.h"

namespace grader::mistakes {
namespace {

using namespace check;

void ask(Battery& battery, const Stage& stage, int samples = 1, int draws = 4000) {
  const Situation s = stage.done();
  battery.estimate(draws, [&](int n, std::uint64_t seed) {
    return repeat<pt::direct_hemisphere>(n, seed, s.scene, s.point, samples);
  });
}

void skies(Battery& battery) {
  for (const pt::Vec3 n : {pt::Vec3{0, 1, 0}, pt::Vec3{1, 0, 0}, pt::Vec3{1, -0.5, 1}}) {
    ask(battery, Stage(turned(n)).sky(kRadiance).patch(kAlbedo, kTilted));
  }
  ask(battery, Stage(turned({0, 1, 0})).sky(kRadiance).patch(kAlbedo, kTilted, true));
}

void lights(Battery& battery) {
  ask(battery, Stage(here()).rectangle(kAbove, kRadiance, Body::surface).patch(kAlbedo, kTilted));
  ask(battery,
      Stage(turned({1, 2, 3})).rectangle(kAbove, kRadiance, Body::surface).patch(kAlbedo, kTilted));
  ask(battery, Stage(turned({-1, 0.2, 0.1}))
                   .rectangle(kAside, kRadiance, Body::surface)
                   .patch(kAlbedo, kTilted, true));
  ask(battery, Stage(here()).surface(kAbove, {0.2, 0.7, 0.4}, kRadiance).patch(kAlbedo, kTilted));
  ask(battery, Stage(here()).surface(kAbove, {0.2, 0.7, 0.4}).patch(kAlbedo, kTilted));
  ask(battery, Stage(here()).rectangle(kAbove, kRadiance, Body::none).patch(kAlbedo, kTilted));
  ask(battery,
      Stage(here()).surface(kAbove.flipped(), {.4, .4, .4}, kRadiance).patch(kAlbedo, kTilted));
  ask(battery,
      Stage(here()).rectangle(kAbove, kRadiance, Body::surface, 0.4).patch(kAlbedo, kTilted));
  // The point itself glows, with and without other light.
  const pt::Rgb glow{5, 4, 3};
  ask(battery, Stage(here()).patch(kAlbedo, kTilted, false, glow));
  ask(battery, Stage(here()).surface(kAbove, {.2, .2, .2}).patch(kAlbedo, kTilted, false, glow));
  ask(battery,
      Stage(here()).surface(kAbove, {.2, .2, .2}, kRadiance).patch(kAlbedo, kTilted, false, glow));
  ask(battery, Stage(here()).point_light({0, 0, 2}, kRadiance).patch(kAlbedo, kTilted));
}

void samples(Battery& battery) {
  for (const int each : {2, 4, 16, 40}) {
    ask(battery, Stage(here()).rectangle(kAbove, kRadiance, Body::surface).patch(kAlbedo, kTilted),
        each, 2000);
  }
}

// A patch inside a glowing box, far from the origin and near it, large and small.
void scales(Battery& battery) {
  for (const double size : {1e-4, 1e-2, 1e2, 1e4}) {
    for (const pt::Vec3 shift : {pt::Vec3{}, pt::Vec3{100, -70, 50}}) {
      Stage stage(here(size, shift));
      for (const Rectangle& wall : cube()) {
        const bool floor = wall.center.z == 0;
        stage.surface(wall, {.3, .3, .3}, floor ? pt::Rgb{} : kRadiance);
      }
      ask(battery, stage.patch(kAlbedo, kTilted), 1, 1000);
    }
    for (const Pose& pose : {here(size), far_away(size)}) {
      Stage lit(pose), hidden(pose);
      lit.rectangle(kAbove, kRadiance, Body::surface).patch(kAlbedo, kTilted);
      hidden.rectangle(kAbove, kRadiance, Body::surface).surface(kPlate, {.5, .5, .5});
      ask(battery, lit, 1, 1000);
      ask(battery, hidden.patch(kAlbedo, kTilted), 1, 1000);
    }
  }
}

// Light of any brightness and any colour, and many directions.
void brightness(Battery& battery) {
  for (const pt::Rgb radiance :
       {pt::Rgb{3e5, 2e5, 1e5}, pt::Rgb{30, 20, 40}, pt::Rgb{3e-3, 2e-3, 1e-3}, pt::Rgb{2, 0, 3}}) {
    ask(battery, Stage(here()).rectangle(kAbove, radiance, Body::surface).patch(kAlbedo, kTilted),
        1, 1000);
  }
  for (const int each : {64, 3000}) {
    ask(battery, Stage(here()).sky(kRadiance).patch(kAlbedo, kTilted), each,
        each == 64 ? 1000 : 60);
  }
}

// Seen from behind, a point that glows on its front. A ray that starts on the wrong side meets it; a
// direction on the wrong side brings nothing.
void glowing_front(Battery& battery) {
  ask(battery, Stage(here()).patch(kAlbedo, kTilted, true, {5, 4, 3}));
}

void sampler(Battery& battery) {
  const Situation s =
      Stage(here()).rectangle(kAbove, kRadiance, Body::surface).patch(kAlbedo, kTilted).done();
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
  sampler(battery);
  glowing_front(battery);
}

}  // namespace grader::mistakes
