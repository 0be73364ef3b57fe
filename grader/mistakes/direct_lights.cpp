#include "pt/tasks/direct_lights.h"

#include "grader/check/repeat.h"
#include "grader/mistakes/battery.h"
#include "grader/mistakes/stages.h"

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Vec3;

void ask(Battery& battery, const Stage& stage, int samples = 1, int draws = 3000) {
  const Situation s = stage.done();
  battery.estimate(draws, [&](int n, std::uint64_t seed) {
    return repeat<pt::direct_lights>(n, seed, s.scene, s.point, samples);
  });
}

// For scenes without randomness: eight draws are enough.
void ask_exactly(Battery& battery, const Stage& stage, int samples = 1) {
  ask(battery, stage, samples, 8);
}

Stage patch(const Pose& pose = here(), bool from_behind = false) {
  return Stage(pose).patch(kAlbedo, kTilted, from_behind);
}

void delta_lights(Battery& battery) {
  const Vec3 side{0.8, 0.6, 0.9};
  for (const int each : {1, 3, 16}) {
    ask_exactly(battery, patch().point_light(side, kRadiance), each);
    ask_exactly(battery, patch().directional_light(side, kRadiance), each);
  }
  for (const Vec3 n : {Vec3{1, 2, 3}, Vec3{-1, 0.1, 0}}) {
    for (const bool behind : {false, true}) {
      ask_exactly(battery, patch(turned(n), behind).point_light(side, kRadiance));
      ask_exactly(battery, patch(turned(n), behind).directional_light({0.9, 0, 0.1}, kRadiance));
    }
  }
  ask_exactly(battery, patch().point_light({0.3, 0.1, -1}, kRadiance));
  ask_exactly(battery, patch().directional_light({0.3, 0.1, -1}, kRadiance));
  ask_exactly(battery, patch().point_light(side, kRadiance, true));
  ask_exactly(battery, patch().directional_light(side, kRadiance, true));
  ask_exactly(battery, patch().point_light({0, 0, 0.1}, kRadiance));
  ask_exactly(battery, patch().point_light({0, 0, 30}, kRadiance));
  // Dark surfaces behind a light hide nothing.
  const Rectangle wall{{0, 0, 3}, {0, 9, 0}, {9, 0, 0}};
  ask_exactly(battery, patch().point_light({0, 0, 2}, kRadiance).surface(wall, {.5, .5, .5}));
  ask_exactly(battery,
              patch().point_light({0, 0, 2}, kRadiance).surface(wall.scaled(0.6667), {.5, .5, .5}));
}

void area_lights(Battery& battery) {
  const Rectangle behind_the_light = kAbove.scaled(1.5);
  for (const Body body : {Body::none, Body::surface}) {
    for (const Rectangle& shape : {kAbove, kAside, kLow}) {
      ask(battery, patch().rectangle(shape, kRadiance, body));
    }
    ask(battery, patch().ball({0.5, 0.3, 1.4}, 0.5, kRadiance, body));
    ask(battery, patch().mesh(kAside, kRadiance, body));
    ask(battery, patch().rectangle(kAbove.flipped(), kRadiance, body));
    ask(battery, patch().rectangle(kAbove, kRadiance, body, 0.4));
    ask(battery,
        patch().rectangle(kAbove, kRadiance, body).surface(behind_the_light, {.5, .5, .5}));
  }
  ask(battery, patch(turned({1, 2, 3})).rectangle(kAside, kRadiance, Body::surface));
  ask(battery, patch(turned({-1, 0.1, 0}), true).rectangle(kAside, kRadiance, Body::surface));
  ask(battery,
      patch(turned({0.2, -1, 0.4}), true).ball({0.5, 0.3, 1.4}, 0.5, kRadiance, Body::none));
  // Half of the light is below the horizon.
  ask(battery, patch().rectangle({{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, kRadiance, Body::none));
  ask(battery, Stage(here())
                   .rectangle(kAbove, kRadiance, Body::surface)
                   .patch(kAlbedo, kTilted, false, {5, 4, 3}));
}

void skies(Battery& battery) {
  for (const Vec3 n : {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, -0.5, 1}}) {
    ask(battery, patch(turned(n)).sky(kRadiance));
  }
  ask(battery, patch(turned({0, 1, 0})).sky(kRadiance).surface(kAbove, {.5, .5, .5}));
}

void several(Battery& battery) {
  const pt::Rgb colors[] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 2, 0}, {0, 1, 2}, {2, 0, 1}};
  for (const int each : {1, 2, 3, 4, 6, 12}) {
    Stage stage = patch();
    for (int i = 0; i < each; ++i) {
      stage.point_light({0.3 * i - 0.5, 0.2, 1.0 + 0.1 * i}, colors[i % 6]);
    }
    ask_exactly(battery, stage);
  }
  for (const int samples : {1, 4}) {
    ask(battery,
        patch()
            .rectangle(kAside, {3, 0, 0}, Body::none)
            .point_light({0.2, 0.3, 1}, {0, 3, 0})
            .ball({-0.8, 0.3, 1.4}, 0.4, {0, 0, 3}, Body::none),
        samples);
    ask(battery,
        patch()
            .point_light({0.2, 0.3, 1}, {0, 3, 0})
            .rectangle(kAside, {3, 0, 0}, Body::none)
            .directional_light({0.3, 0.2, 1}, {0, 0, 1}),
        samples);
  }
}

void samples(Battery& battery) {
  for (const int each : {2, 4, 16, 40}) {
    ask(battery, patch().rectangle(kAside, kRadiance, Body::surface), each, 1200);
    ask(battery, patch().ball({0.5, 0.3, 1.4}, 0.5, kRadiance, Body::none), each, 1200);
  }
}

void scales(Battery& battery) {
  for (const double size : {1e-4, 1e-2, 1e2, 1e4}) {
    for (const Vec3 shift : {Vec3{}, Vec3{100, -70, 50}}) {
      ask_exactly(battery, patch(here(size, shift)).point_light({0.8, 0.6, 0.9}, kRadiance));
      ask(battery, patch(here(size, shift)).rectangle(kAside, kRadiance, Body::surface), 1, 1000);
      // A dark plate close to the point.
      ask_exactly(
          battery,
          patch(here(size, shift)).point_light({0, 0, 1}, kRadiance).surface(kPlate, {.5, .5, .5}));
    }
    for (const Vec3 light : {Vec3{0.8, 0.6, 0.9}, Vec3{0.9, 0, 0.05}}) {
      ask_exactly(battery, patch(far_away(size)).point_light(light, kRadiance));
    }
  }
}

// Lights of any brightness, at flat angles, many of them, and a surface just before a light.
void extremes(Battery& battery) {
  for (const pt::Rgb radiance : {pt::Rgb{3e5, 2e5, 1e5}, pt::Rgb{3e-4, 2e-4, 1e-4}}) {
    ask_exactly(battery, patch().point_light({0.8, 0.6, 0.9}, radiance));
    ask(battery, patch().rectangle(kAside, radiance, Body::surface), 1, 1000);
  }
  ask_exactly(battery, patch().directional_light({1, 0, 0.005}, kRadiance));
  Stage many = patch();
  for (int i = 0; i < 40; ++i) many.point_light({0.1 * i - 2, 0.3, 1 + 0.02 * i}, kRadiance);
  ask_exactly(battery, many);
  for (const double way : {0.98, 0.995}) {
    const Rectangle plate{{0, 0, 2 * way}, {0, 1, 0}, {1, 0, 0}};
    ask_exactly(battery, patch().point_light({0, 0, 2}, kRadiance).surface(plate, {.5, .5, .5}));
  }
}

void sampler(Battery& battery) {
  const Situation s = patch().rectangle(kAside, kRadiance, Body::surface).done();
  battery.ask([&] {
    return use_of_sampler([&](pt::Sampler& sampler) {
      return numbers(pt::direct_lights(s.scene, s.point, 4, sampler));
    });
  });
}

}  // namespace

void run_battery(Battery& battery) {
  delta_lights(battery);
  area_lights(battery);
  skies(battery);
  several(battery);
  samples(battery);
  scales(battery);
  extremes(battery);
  sampler(battery);
}

}  // namespace grader::mistakes
