#include "grader/mistakes/battery.h"

#include "grader/check/language/repeat.h"
#include "grader/mistakes/patches.h"
#include "grader/tasks/trace_path/inputs.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;
using namespace trace_path_inputs;

constexpr Direct kHemisphere = Direct::hemisphere, kLights = Direct::lights;

rc::Gen<Rgb> albedo() { return rc::gen::just(Rgb{0.8, 0.5, 0.3}); }

// Asks for the light at the point of a room or of a situation.
template <class Seen>
void ask(Battery& battery, const Seen& seen, const PathSettings& settings, int draws = 2000) {
  battery.estimate(draws, [&](int n, std::uint64_t seed) {
    return repeat<pt::trace_path>(n, seed, seen.scene, seen.point, settings);
  });
}

// Different ranges of bounces, and different survivals.
void depths(Battery& battery, const Room& room, Direct direct) {
  constexpr Bounces kBounces[] = {{0, 1}, {1, 1}, {2, 2}, {3, 3}, {1, 2},
                                  {1, 4}, {2, 5}, {0, 8}, {1, 12}};
  for (const Bounces& which : kBounces) ask(battery, room, settings_of(which, direct));
  for (const double survival : {0.3, 1.0}) {
    for (const Bounces& which : {kBounces[4], kBounces[5], kBounces[6]}) {
      PathSettings settings = settings_of(which, direct);
      settings.survival = survival;
      ask(battery, room, settings);
    }
  }
}

void light_samples(Battery& battery, const Room& glowing, const Room& lamp) {
  for (const int samples : {4, 16}) {
    PathSettings settings = settings_of({1, 1}, kHemisphere);
    settings.light_samples = samples;
    ask(battery, glowing, settings);
    ask(battery, lamp, settings);
    settings.direct = kLights;
    ask(battery, lamp, settings);
    settings.to = 3;
    ask(battery, lamp, settings);
  }
}

void walls(Battery& battery, bool open, Direct direct) {
  SceneMaker maker = patch();
  colored_walls(maker, open, kRadiance);
  const Situation s = maker.done();
  for (const Bounces& which : {Bounces{2, 2}, Bounces{3, 3}, Bounces{1, 5}}) {
    ask(battery, s, settings_of(which, direct));
  }
}

// Light of any brightness from one bounce and from two, and empty ranges of bounces.
void extremes(Battery& battery) {
  for (const Rgb radiance : {Rgb{3e5, 2e5, 1e5}, Rgb{60, 40, 50}}) {
    SceneMaker maker = patch().point_light({0.4, 0.3, 0.5}, radiance);
    for (const Rectangle& side : cube()) maker.surface(side, {.5, .6, .4});
    const Situation s = maker.done();
    for (const Bounces& which : {Bounces{1, 1}, Bounces{2, 2}, Bounces{3, 1}}) {
      ask(battery, s, settings_of(which), 1000);
    }
  }
}

// Only one bounce, far along the path. All paths survive, so that few paths are enough. Little light
// is left in dark rooms, and all of it in white rooms.
void far_bounces(Battery& battery) {
  struct {
    double albedo;
    int bounce, draws;
  } constexpr kFar[] = {{1, 60, 150}, {0.9, 30, 60}, {0.2, 8, 60}, {0.02, 8, 60}};
  for (const auto& [albedo, bounce, draws] : kFar) {
    PathSettings settings = settings_of({bounce, bounce});
    settings.survival = 1;
    ask(battery, made(round_room(gray(albedo, albedo)), 17), settings, draws);
  }
}

// The brightest of many estimates of bounce 3 in a white room, in tenths of a power of ten. The direct
// light is 1 at every point, so an estimate is the throughput of the path. A path that survives the
// only roulette stands for 200 paths; of 2000 paths, ten survive.
void survivors(Battery& battery) {
  const Room white = lit_from_the_middle(made(round_room(gray(1, 1)), 18));
  PathSettings settings = settings_of({3, 3});
  settings.survival = 0.005;
  battery.ask([&]() -> Battery::Numbers {
    double most = 1e-3;
    for (const Rgb& one : repeat<pt::trace_path>(2000, 18, white.scene, white.point, settings)) {
      most = std::max(most, one.g);
    }
    return {std::round(10 * std::log10(most))};
  });
}

// The brightest and the faintest light that the contract knows.
void brightness(Battery& battery) {
  for (const double intensity : {1e12, 1e-4}) {
    Ranges ranges = ordinary();
    ranges.light = rc::gen::just(intensity * Rgb{0.5, 1, 0.7});
    ask(battery, made(round_room(albedo(), ranges), 19), settings_of({1, 2}), 60);
  }
}

// Surfaces that are seen from straight above, and at a grazing angle.
void views(Battery& battery) {
  // The mock diffuse_sample draws uniform directions here (grader/tasks/diffuse_bsdf/mock.cpp).
  ask(battery, seen_at(made(sunny_wall(albedo(), 0.3), 20), 1), settings_of({2, 2}), 500);
  for (const double cosine : {5e-3, 1e-7}) {
    ask(battery, seen_at(made(round_room(albedo()), 21), cosine), settings_of({1, 2}), 60);
  }
}

// A low wall in the light of two suns. The wall glows, or the normal of the true surface at the
// point, not the shading normal, leans towards it.
void low_walls(Battery& battery) {
  for (const bool glows : {false, true}) {
    SceneMaker maker = SceneMaker(here()).point(kAlbedo, kTilted);
    low_wall(maker, kAlbedo, pt::gray(glows ? 3 : 0), kRadiance);
    Situation s = maker.done();
    if (!glows) s.point.geometric_normal = normalize(pt::Vec3{0.4, 0, 1});
    ask(battery, s, settings_of({2, 2}), 800);
  }
}

// Walls that reflect no red.
void no_red(Battery& battery) {
  ask(battery, made(round_room(rc::gen::just(Rgb{0, 0.6, 0.8})), 23), settings_of({3, 3}), 200);
}

// Many samples of direct light, found by hemisphere sampling. More samples have less noise: at the
// first bounce, with lights that bring nothing, and at the second bounce, with a small lamp.
void many_light_samples(Battery& battery) {
  SceneMaker maker = patch().surface(kAbove, {}, kRadiance);
  lights_below(maker, 5);
  PathSettings settings = settings_of({1, 1}, kHemisphere);
  settings.light_samples = 12;
  ask(battery, maker.done(), settings, 500);
  const Room lamp = made(room_around_a_small_lamp(albedo()), 24);
  for (const int from : {1, 2}) {
    settings = settings_of({from, 2}, kHemisphere);
    settings.light_samples = 64;
    ask(battery, lamp, settings, 300);
  }
}

void sampler(Battery& battery, const Room& room) {
  battery.ask([&] {
    return use_of_sampler([&](pt::Sampler& sampler) {
      return numbers(pt::trace_path(room.scene, room.point, settings_of({1, 3}), sampler));
    });
  });
}

}  // namespace

void run_battery(Battery& battery) {
  const Room round = made(round_room(albedo()), 11), glowing = made(glowing_room(albedo()), 12);
  const Room lamp = made(room_around_a_lamp(albedo(), rc::gen::just(kLights)), 13),
             sunny = made(sunny_wall(albedo()), 14);
  const Room black = made(round_room(gray(0, 0)), 15), half = made(round_room(gray(.5, .5)), 16);
  depths(battery, round, kLights);
  depths(battery, glowing, kHemisphere);
  ask(battery, round, settings_of({1, 3}, kHemisphere));
  ask(battery, glowing, settings_of({1, 3}, kLights));
  for (const Direct direct : {kHemisphere, kLights}) {
    ask(battery, lamp, settings_of({0, 1}, direct));
    ask(battery, lamp, settings_of({1, 3}, direct));
    ask(battery, sunny, settings_of({0, 2}, direct));
    ask(battery, sunny, settings_of({2, 4}, direct));
  }
  light_samples(battery, glowing, lamp);
  for (const bool open : {false, true}) {
    for (const Direct direct : {kHemisphere, kLights}) walls(battery, open, direct);
  }
  ask(battery, black, settings_of({1, 4}));
  ask(battery, half, settings_of({1, 4}));
  ask(battery, half, settings_of({2, 2}));
  extremes(battery);
  far_bounces(battery);
  survivors(battery);
  brightness(battery);
  views(battery);
  low_walls(battery);
  ask(battery, made(smooth_wall_in_a_hall(), 21), settings_of({3, 3}));
  no_red(battery);
  many_light_samples(battery);
  sampler(battery, round);
  sampler(battery, sunny);
}

}  // namespace grader::mistakes
