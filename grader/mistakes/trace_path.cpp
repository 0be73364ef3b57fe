#include "pt/tasks/trace_path.h"

#include "grader/check/repeat.h"
#include "grader/check/rooms.h"
#include "grader/mistakes/battery.h"
#include "grader/mistakes/patches.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::PathSettings;

// Always makes the same room: the generator runs with a fixed seed.
Room made(const rc::Gen<Room>& rooms, std::uint64_t seed) {
  return rooms(rc::Random(seed), rc::kNominalSize).value();
}

rc::Gen<pt::Rgb> albedo() { return rc::gen::just(pt::Rgb{0.8, 0.5, 0.3}); }

void ask(Battery& battery, const Room& room, PathSettings settings, int draws = 2000) {
  battery.estimate(draws, [&](int n, std::uint64_t seed) {
    return repeat<pt::trace_path>(n, seed, room.scene, room.point, settings);
  });
}

PathSettings bounces(int from, int to, PathSettings::Direct direct = PathSettings::Direct::lights) {
  PathSettings settings;
  settings.from = from;
  settings.to = to;
  settings.direct = direct;
  return settings;
}

// Different ranges of bounces, and different survivals.
void depths(Battery& battery, const Room& room, PathSettings::Direct direct) {
  constexpr std::array<int, 2> kBounces[] = {{0, 1}, {1, 1}, {2, 2}, {3, 3}, {1, 2},
                                             {1, 4}, {2, 5}, {0, 8}, {1, 12}};
  for (const auto& [from, to] : kBounces) ask(battery, room, bounces(from, to, direct));
  for (const double survival : {0.3, 1.0}) {
    for (const auto& [from, to] : {kBounces[4], kBounces[5], kBounces[6]}) {
      PathSettings settings = bounces(from, to, direct);
      settings.survival = survival;
      ask(battery, room, settings);
    }
  }
}

// A box with walls of different colours, closed or with one side open to the sky.
void walls(Battery& battery, bool open, PathSettings::Direct direct) {
  using namespace mistakes;
  constexpr pt::Rgb kColors[] = {
      {.9, .3, .3}, {.2, .8, .3}, {.3, .4, .9}, {.8, .8, .1}, {.1, .7, .9}};
  SceneMaker maker(here());
  maker.patch(kAlbedo, kTilted);
  const std::vector<Rectangle> sides = cube();
  for (std::size_t i = open ? 2 : 0; i < std::size(kColors); ++i) {
    maker.surface(sides[i], kColors[i], open ? pt::Rgb{} : pt::Rgb{0.1, 0.2, 0.1});
  }
  if (open) maker.sky(kRadiance);
  maker.point_light({0.4, 0.3, 0.5}, kRadiance);
  const Situation s = maker.done();
  for (const auto& [from, to] : {std::pair(2, 2), std::pair(3, 3), std::pair(1, 5)}) {
    const PathSettings settings = bounces(from, to, direct);
    battery.estimate(2000, [&](int n, std::uint64_t seed) {
      return repeat<pt::trace_path>(n, seed, s.scene, s.point, settings);
    });
  }
}

// Light of any brightness from one bounce and two, and bounces of which there are none.
void extremes(Battery& battery) {
  for (const pt::Rgb radiance : {pt::Rgb{3e5, 2e5, 1e5}, pt::Rgb{60, 40, 50}}) {
    SceneMaker maker(here());
    maker.patch(kAlbedo, kTilted).point_light({0.4, 0.3, 0.5}, radiance);
    for (const Rectangle& side : cube()) maker.surface(side, {.5, .6, .4});
    const Situation s = maker.done();
    for (const auto& [from, to] : {std::pair(1, 1), std::pair(2, 2), std::pair(3, 1)}) {
      const PathSettings settings = bounces(from, to);
      battery.estimate(1000, [&](int n, std::uint64_t seed) {
        return repeat<pt::trace_path>(n, seed, s.scene, s.point, settings);
      });
    }
  }
}

rc::Gen<pt::Rgb> gray(double albedo) { return rc::gen::just(pt::gray(albedo)); }

// One bounce far along the path, alone. All paths survive, so that few of them say enough. The share
// of light that is left becomes small in dark rooms, and stays in white ones.
void far_bounces(Battery& battery) {
  struct {
    double albedo;
    int bounce, draws;
  } constexpr kFar[] = {{1, 60, 150}, {0.9, 30, 60}, {0.2, 8, 60}, {0.02, 8, 60}};
  for (const auto& [albedo, bounce, draws] : kFar) {
    PathSettings settings = bounces(bounce, bounce);
    settings.survival = 1;
    ask(battery, made(round_room(gray(albedo)), 17), settings, draws);
  }
}

// The brightest of many estimates of bounce 3 in a white room, in tenths of a power of ten. The direct
// light is 1 at every point, so an estimate is the throughput of the path. A path that survives the
// only roulette stands for 200 paths; of 2000 paths, ten survive.
void survivors(Battery& battery) {
  Room white = made(round_room(gray(1)), 18);
  const pt::Sphere ball = white.scene.primitives.spheres[0];
  white.scene.lights = {pt::PointLight{ball.center, ball.radius * ball.radius * pt::gray(pt::kPi)}};
  PathSettings settings = bounces(3, 3);
  settings.survival = 0.005;
  battery.ask([&]() -> Battery::Numbers {
    double most = 1e-3;
    for (const pt::Rgb& one :
         repeat<pt::trace_path>(2000, 18, white.scene, white.point, settings)) {
      most = std::max(most, one.g);
    }
    return {std::round(10 * std::log10(most))};
  });
}

// The brightest and the faintest light that the contract knows.
void brightness(Battery& battery) {
  for (const double intensity : {1e12, 1e-4}) {
    Ranges ranges = ordinary();
    ranges.light = rc::gen::just(intensity * pt::Rgb{0.5, 1, 0.7});
    ask(battery, made(round_room(albedo(), ranges), 19), bounces(1, 2), 60);
  }
}

// Surfaces that are seen from straight above, and at a grazing angle.
void views(Battery& battery) {
  // The mock diffuse_sample draws uniform directions here (grader/check/mock_diffuse_bsdf.cpp).
  Room above = made(sunny_wall(albedo(), 0.3), 20);
  above.point.wo = above.point.n;
  ask(battery, above, bounces(2, 2), 500);
  for (const double cosine : {5e-3, 1e-7}) {
    Room grazed = made(round_room(albedo()), 21);
    grazed.point.wo = grazed.point.frame.to_world({std::sqrt(1 - cosine * cosine), 0, cosine});
    ask(battery, grazed, bounces(1, 2), 60);
  }
}

// A low wall in the light of two suns. It glows, or the normal of the true surface at the point, not
// the shading normal, leans towards it.
void low_walls(Battery& battery) {
  for (const bool glows : {false, true}) {
    SceneMaker maker(here());
    maker.point(kAlbedo, kTilted).directional_light({-0.6, 0, 0.8}, kRadiance);
    maker.directional_light({-0.8, 0, 0.6}, kRadiance);
    maker.surface({{0.6, 0, 0.2}, {0, 0, 0.4}, {0, 2.4, 0}}, kAlbedo, pt::gray(glows ? 3 : 0));
    Situation s = maker.done();
    if (!glows) s.point.geometric_normal = normalize(pt::Vec3{0.4, 0, 1});
    battery.estimate(800, [&](int n, std::uint64_t seed) {
      return repeat<pt::trace_path>(n, seed, s.scene, s.point, bounces(2, 2));
    });
  }
}

// Walls that reflect no red.
void no_red(Battery& battery) {
  ask(battery, made(round_room(rc::gen::just(pt::Rgb{0, 0.6, 0.8})), 23), bounces(3, 3), 200);
}

// Many samples of direct light, found by hemisphere sampling. More of them have less noise: at the
// first bounce, beside lights that bring nothing, and at the second one, where the lamp is small.
void many_light_samples(Battery& battery) {
  constexpr auto kHemisphere = PathSettings::Direct::hemisphere;
  SceneMaker maker(here());
  maker.patch(kAlbedo, kTilted).surface(kAbove, {}, kRadiance);
  for (int i = 0; i < 5; ++i) maker.directional_light({0, 0, -1}, kRadiance);
  const Situation s = maker.done();
  PathSettings settings = bounces(1, 1, kHemisphere);
  settings.light_samples = 12;
  battery.estimate(500, [&](int n, std::uint64_t seed) {
    return repeat<pt::trace_path>(n, seed, s.scene, s.point, settings);
  });
  const Room lamp = made(
      room_around_a_lamp(albedo(), rc::gen::just(kHemisphere), ordinary(), rc::gen::just(0.2)), 24);
  for (const int from : {1, 2}) {
    settings = bounces(from, 2, kHemisphere);
    settings.light_samples = 64;
    ask(battery, lamp, settings, 300);
  }
}

void sampler(Battery& battery, const Room& room) {
  battery.ask([&] {
    return use_of_sampler([&](pt::Sampler& sampler) {
      const PathSettings settings = bounces(1, 3);
      return numbers(pt::trace_path(room.scene, room.point, settings, sampler));
    });
  });
}

}  // namespace

void run_battery(Battery& battery) {
  constexpr auto kHemisphere = PathSettings::Direct::hemisphere;
  constexpr auto kLights = PathSettings::Direct::lights;
  const Room round = made(round_room(albedo()), 11), glowing = made(glowing_room(albedo()), 12);
  const Room lamp = made(room_around_a_lamp(albedo(), rc::gen::just(kLights)), 13),
             sunny = made(sunny_wall(albedo()), 14);
  const Room black = made(round_room(rc::gen::just(pt::Rgb{})), 15);
  const Room gray = made(round_room(rc::gen::just(pt::Rgb{0.5, 0.5, 0.5})), 16);
  depths(battery, round, kLights);
  depths(battery, glowing, kHemisphere);
  ask(battery, round, bounces(1, 3, kHemisphere));
  ask(battery, glowing, bounces(1, 3, kLights));
  for (const auto direct : {kHemisphere, kLights}) {
    ask(battery, lamp, bounces(0, 1, direct));
    ask(battery, lamp, bounces(1, 3, direct));
    ask(battery, sunny, bounces(0, 2, direct));
    ask(battery, sunny, bounces(2, 4, direct));
  }
  for (const int samples : {4, 16}) {
    PathSettings settings = bounces(1, 1, kHemisphere);
    settings.light_samples = samples;
    ask(battery, glowing, settings);
    ask(battery, lamp, settings);
    settings.direct = kLights;
    ask(battery, lamp, settings);
    settings.to = 3;
    ask(battery, lamp, settings);
  }
  for (const bool open : {false, true}) {
    for (const auto direct : {kHemisphere, kLights}) walls(battery, open, direct);
  }
  ask(battery, black, bounces(1, 4));
  ask(battery, gray, bounces(1, 4));
  ask(battery, gray, bounces(2, 2));
  extremes(battery);
  far_bounces(battery);
  survivors(battery);
  brightness(battery);
  views(battery);
  low_walls(battery);
  no_red(battery);
  many_light_samples(battery);
  sampler(battery, round);
}

}  // namespace grader::mistakes
