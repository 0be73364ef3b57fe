#include "grader/mistakes/battery.h"

#include "grader/check/language/repeat.h"
#include "grader/mistakes/patches.h"
#include "grader/tasks/direct_lights/inputs.h"
#include "pt/tasks/direct_lights.h"

namespace grader::mistakes {
namespace {

using namespace check;
using namespace direct_lights_inputs;

using pt::Vec3;

void ask(Battery& battery, const Situation& s, int samples = 1, int draws = 3000) {
  battery.estimate(draws, [&](int n, std::uint64_t seed) {
    return repeat<pt::direct_lights>(n, seed, s.scene, s.point, samples);
  });
}

void ask(Battery& battery, const SceneMaker& maker, int samples = 1, int draws = 3000) {
  ask(battery, maker.done(), samples, draws);
}

// For scenes without randomness: eight draws are enough.
void ask_exactly(Battery& battery, const SceneMaker& maker, int samples = 1) {
  ask(battery, maker, samples, 8);
}

// Asks whether the point is black, if nothing else matters, or if light is so weak that right
// answers differ.
void ask_if_black(Battery& battery, const SceneMaker& maker) {
  const Situation s = maker.done();
  battery.ask([&]() -> Battery::Numbers {
    pt::Sampler sampler(7);
    return {flag(is_black(pt::direct_lights(s.scene, s.point, 1, sampler)))};
  });
}

// Returns a patch under a point light, with a dark plate across the way to it.
SceneMaker with_a_plate(double way, double side) {
  const Vec3 light{0, 0, 2};
  return patch().point_light(light, kRadiance).surface(across(light, way, side), {.5, .5, .5});
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
  for (const double way : {1.5, 1.00005}) ask_exactly(battery, with_a_plate(way, 9));
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
  ask(battery, patch(here(), false, {5, 4, 3}).rectangle(kAbove, kRadiance, Body::surface));
}

void skies(Battery& battery) {
  for (const Vec3 n : {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, -0.5, 1}, Vec3{0.5, -0.8, 0.2}}) {
    ask(battery, patch(turned(n)).sky(kRadiance));
  }
  ask(battery, patch(turned({0, 1, 0})).sky(kRadiance).surface(kAbove, {.5, .5, .5}));
}

void several(Battery& battery) {
  for (const int each : {1, 2, 3, 4, 6, 12}) {
    SceneMaker maker = patch();
    point_lights_of_six_colors(maker, each);
    ask_exactly(battery, maker);
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

// The normal of the true surface is not the shading normal.
void smooth_shading(Battery& battery) {
  Situation s =
      SceneMaker(here()).point(kAlbedo, kTilted).point_light({0.8, 0.6, 0.9}, kRadiance).done();
  s.point.geometric_normal = normalize(Vec3{0.3, -0.1, 0.9});
  ask(battery, s, 1, 8);
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
  ask_exactly(battery, patch().point_light({0.01, 0, 0.02}, 1e6 * kRadiance));
  SceneMaker many = patch();
  row_of_point_lights(many, 40, kRadiance);
  ask_exactly(battery, many);
  for (const double way : {0.98, 0.995}) ask_exactly(battery, with_a_plate(way, 1));
}

// Lights that give nothing (hidden or below the horizon), before a point light that does.
void after_dark_lights(Battery& battery) {
  const Vec3 aside{-0.8, -0.2, 0.9};
  ask_if_black(battery,
               patch().point_light({0.8, 0.2, 0.9}, kRadiance, true).point_light(aside, kRadiance));
  ask_if_black(battery,
               patch().rectangle(kAside, kRadiance, Body::none, 1).point_light(aside, kRadiance));
  ask_if_black(battery,
               patch().point_light({0.8, 0.2, -0.9}, kRadiance).point_light(aside, kRadiance));
}

// A hundred lights that all give light. Then a hundred lights, and only a half hidden lamp gives
// light: its noise shows how many samples it gets.
void hundred_lights(Battery& battery) {
  SceneMaker all = patch(), one = patch().rectangle(kAside, kRadiance, Body::none, 0.5);
  row_of_point_lights(all, 100, kRadiance);
  for (int i = 1; i < 100; ++i) one.point_light({0, 0.1, -1}, kRadiance);
  ask_exactly(battery, all);
  ask(battery, one, 40, 300);
}

// Two lamps in one place, half hidden. If they have the same random numbers, they are bright and
// dark together.
void two_lamps(Battery& battery) {
  ask(battery, patch()
                   .rectangle(kAside, kRadiance, Body::none, 0.5)
                   .rectangle(kAside, kRadiance, Body::none));
}

// Draws that bring no light, among draws that do.
void some_dark_draws(Battery& battery) {
  ask(battery, patch().rectangle(kAside, kRadiance, Body::none, 0.4), 4, 1000);
  ask(battery, patch(turned({1, 0, 0})).sky(kRadiance), 80, 40);
}

// Surfaces that hide the middle of a mesh, the middle of a ball, and a point light. The last one
// glows.
void shadows(Battery& battery) {
  ask(battery, patch().mesh(kAside, kRadiance, Body::none, 0.75));
  const Rectangle shade{{0.15, 0.15, 0.7}, {0, 0.9, 0}, {0.4, 0, 0}};
  ask(battery,
      patch().ball({0.5, 0.3, 1.4}, 0.5, kRadiance, Body::none).surface(shade, {.5, .5, .5}));
  ask_if_black(battery,
               patch().point_light({0, 0, 2}, kRadiance).surface(kAbove, {.5, .5, .5}, kRadiance));
}

// Lights, and surfaces that hide lights, a million units away.
void far_ways(Battery& battery) {
  const Vec3 side = normalize(Vec3{0.8, 0.6, 0.9});
  ask_if_black(battery, SceneMaker(here(1e6)).point(kAlbedo, kTilted).point_light(side, kRadiance));
  ask_if_black(battery, patch(here(1e6)).directional_light(side, kRadiance, true));
  ask(battery, patch(here(1e6)).dark_ball({0, 0, 1.2}, 1.5).sky(kRadiance), 1, 500);
}

// Light from a twelfth of a degree above the horizon, and from below that. Then a low ball.
void low_lights(Battery& battery) {
  for (const double height : {1.4e-3, 5e-4, 5e-6}) {
    ask_if_black(battery, patch().directional_light(normalize(Vec3{1, 0, height}), kRadiance));
  }
  ask(battery, patch().ball({1, 0, 0.015}, 0.006, kRadiance, Body::none), 1, 500);
}

// A surface must not shadow itself.
void far_from_the_origin(Battery& battery) {
  for (const double size : {1e-3, 1.0, 1e3, 1e6}) {
    for (const Pose& pose : farthest(size)) {
      ask_if_black(battery, patch(pose).point_light({0.8, 0.6, 0.9}, kRadiance));
    }
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
  smooth_shading(battery);
  after_dark_lights(battery);
  hundred_lights(battery);
  two_lamps(battery);
  some_dark_draws(battery);
  shadows(battery);
  far_ways(battery);
  low_lights(battery);
  far_from_the_origin(battery);
}

}  // namespace grader::mistakes
