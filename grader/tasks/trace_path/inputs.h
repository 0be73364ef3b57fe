#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/closed_forms.h"
#include "grader/check/scenes/rooms.h"
#include "grader/check/scenes/smooth_shading.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

// Rooms, and the settings of a path in them.

namespace grader::check::trace_path_inputs {

using pt::PathSettings;
using pt::Rgb;
using Direct = PathSettings::Direct;

struct Case {
  Room room;
  PathSettings settings;
  std::uint64_t seed = 0;
};

inline void showValue(const Case& c, std::ostream& out) {
  const PathSettings& s = c.settings;
  showValue(c.room, out);
  out << fmt::format("\nbounces {} to {}; direct light by {}, samples {}; survival {:.4g}", s.from,
                     s.to, s.direct == Direct::lights ? "lights" : "hemisphere", s.light_samples,
                     s.survival);
}

// The bounces to add up, from .. to.
struct Bounces {
  int from = 1, to = 1;
};

inline PathSettings settings_of(Bounces which, Direct direct = Direct::lights) {
  PathSettings settings;
  settings.from = which.from;
  settings.to = which.to;
  settings.direct = direct;
  return settings;
}

// Any range of bounces within low .. high.
inline rc::Gen<Bounces> bounces(int low, int high) {
  return rc::gen::exec([=] {
    const int from = *whole(low, high);
    return Bounces{from, *whole(from, high)};
  });
}

inline rc::Gen<Rgb> gray(double low, double high) {
  return rc::gen::map(real(low, high), [](double x) { return pt::gray(x); });
}

inline rc::Gen<Direct> either_way() { return rc::gen::element(Direct::lights, Direct::hemisphere); }

// The bounces from `from` to any number in low .. high.
inline rc::Gen<Bounces> bounces_from(int from, int low, int high) {
  return rc::gen::map(whole(low, high), [=](int to) { return Bounces{from, to}; });
}

// One bounce, any in low .. high.
inline rc::Gen<Bounces> bounces_of_one(int low, int high) {
  return rc::gen::map(whole(low, high), [](int bounce) { return Bounces{bounce, bounce}; });
}

// By default very few paths end by roulette, so that a mistake in roulette breaks only the promises
// that vary survival. (If none ended, a path that ignores the cap would never end.)
inline rc::Gen<Case> asked_of(const rc::Gen<Room>& rooms, const rc::Gen<Bounces>& which,
                              const rc::Gen<double>& survival = rc::gen::just(0.998)) {
  return rc::gen::exec([=] {
    Case c{*rooms, {}, 0};
    c.settings = settings_of(*which, c.room.direct);
    c.settings.light_samples = *whole(1, 3);
    c.settings.survival = *survival;
    c.seed = *sampler_seed();
    return c;
  });
}

// A lamp that fills a twenty-fifth of the hemisphere, weighted by the cosine, found by hemisphere
// sampling.
inline rc::Gen<Room> room_around_a_small_lamp(const rc::Gen<Rgb>& albedo = gray(0.3, 0.8)) {
  return room_around_a_lamp(albedo, rc::gen::just(Direct::hemisphere), ordinary(),
                            rc::gen::just(0.2));
}

// A closed room in which light sampling finds all light, or one in which hemisphere sampling does.
inline rc::Gen<Room> closed_room(const rc::Gen<Rgb>& albedo) {
  return rc::gen::oneOf(round_room(albedo), glowing_room(albedo));
}

// One bounce of paths that survive rarely, in a room that absorbs almost nothing.
inline rc::Gen<Case> bright_paths(int bounce, double survival) {
  return asked_of(round_room(gray(0.97, 1)), rc::gen::just(Bounces{bounce, bounce}),
                  rc::gen::just(survival));
}

// Paths that may end before each bounce, in a room in which the direction of the bounce decides what
// light is found.
inline rc::Gen<Case> mortal_paths_around_a_lamp(Direct direct) {
  return asked_of(room_around_a_lamp(gray(0.3, 0.6), rc::gen::just(direct)), bounces_of_one(3, 4),
                  real(0.3, 0.5));
}

// The same in a room in which each direction of the path decides whether it finds light.
inline rc::Gen<Case> mortal_paths_in(const rc::Gen<Room>& room) {
  return asked_of(room, rc::gen::just(Bounces{4, 4}), real(0.5, 0.6));
}

// Some bounces far along paths of which most survive all of them.
inline rc::Gen<Case> mortal_paths_far_along() {
  return rc::gen::exec([] {
    const int from = *whole(3, 20), to = *whole(from, from + 3);
    return *asked_of(closed_room(gray(0.7, 1)), rc::gen::just(Bounces{from, to}),
                     rc::gen::just(std::pow(*real(0.6, 0.75), 1.0 / to)));
  });
}

// A point light of intensity 1e6 in a room of radius 1e-3.
inline Ranges brightest() {
  Ranges ranges = ordinary();
  ranges.size = 1e3;
  ranges.light = rc::gen::map(color(0.25, 1), [](Rgb light) { return 1e12 * light; });
  ranges.small = true;
  return ranges;
}

// A wall that glows and reflects the light of one or two suns. It is not in the list
// of lights, so that its own light does not count.
inline rc::Gen<Room> glowing_wall_in_the_sun() {
  return rc::gen::map(sunny_wall(gray(0.2, 1)), [](Room room) {
    for (pt::Material& material : room.scene.materials) material.emission = pt::gray(3);
    room.text += "the wall glows\n";
    return room;
  });
}

// A wall in the sun above a point that is shaded smoothly.
inline rc::Gen<Room> wall_above_a_smooth_point() {
  return rc::gen::exec([] {
    Room room = *sunny_wall(gray(0.2, 1));
    room.point = smoothly_shaded(room.point);
    return room;
  });
}

// Returns the room with its point seen at this cosine to the normal.
inline Room seen_at(Room room, double cosine) {
  room.point.wo = room.point.frame.to_world({std::sqrt(1 - cosine * cosine), 0, cosine});
  return room;
}

// For a surface seen from straight above, the mock diffuse_sample draws uniform directions
// (grader/tasks/diffuse_bsdf/mock.cpp).
inline rc::Gen<Case> seen_from_straight_above() {
  return rc::gen::exec([] {
    Case made = *asked_of(sunny_wall(gray(0.2, 1), 0.3), bounces(2, 2));
    made.room = seen_at(made.room, 1);
    return made;
  });
}

// The same in a room that absorbs little. A path that goes on in a steep direction carries more light
// than one: f cos / pdf of a uniform direction is up to twice the albedo.
inline rc::Gen<Case> bright_and_seen_from_straight_above() {
  return rc::gen::exec([] {
    Case made = *asked_of(round_room(gray(0.8, 1)), rc::gen::just(Bounces{3, 3}), real(0.5, 1));
    made.room = seen_at(made.room, 1);
    return made;
  });
}

// A room that absorbs almost everything.
inline rc::Gen<Case> in_a_dark_room() {
  const rc::Gen<Rgb> dark = rc::gen::map(magnitude(1e-8, 1e-3), pt::gray);
  return asked_of(round_room(dark), rc::gen::just(Bounces{2, 2}));
}

// One channel is bright everywhere, so that roulette by the throughput keeps enough paths. One is
// black.
inline rc::Gen<Case> tinted(int bright, int black, const rc::Gen<Bounces>& which) {
  const rc::Gen<Rgb> tint = rc::gen::map(color(0, 1), [=](Rgb albedo) {
    albedo[bright] = 0.3 + 0.7 * albedo[bright];
    if (black != bright) albedo[black] = 0;
    return albedo;
  });
  return asked_of(room_around_a_lamp(tint, rc::gen::just(Direct::lights)), which);
}

// A point that is seen at a grazing angle. In some channels, or in all, nothing is reflected.
inline rc::Gen<Case> grazed_and_black() {
  return rc::gen::exec([] {
    const bool all = *rc::gen::element(true, false, false, false);
    const int black = *whole(0, 2);
    const rc::Gen<Rgb> some_black = rc::gen::map(color(0.3, 0.8), [=](Rgb albedo) {
      if (all) return Rgb{};
      albedo[black] = 0;
      return albedo;
    });
    const rc::Gen<Bounces> which = rc::gen::exec([] {
      return Bounces{*whole(1, 2), *whole(2, 6)};
    });
    Case made = *asked_of(room_around_a_lamp(some_black, either_way()), which);
    made.room = seen_at(made.room, *magnitude(1e-8, 0.1));
    return made;
  });
}

// One bounce far along the path. A float can still show its light: 1e-25 of it is left.
inline rc::Gen<Case> far_along() {
  return rc::gen::exec([] {
    const double albedo = *rc::gen::oneOf(real(0.2, 1), rc::gen::just(1.0));
    const double most = albedo < 1 ? -57 / std::log(albedo) : 100;
    const int to = std::clamp(static_cast<int>(most), 10, 100);
    return *asked_of(round_room(gray(albedo, albedo)), rc::gen::just(Bounces{to, to}),
                     rc::gen::element(1.0, 1.0, 1.0, 0.8));
  });
}

// A patch under two rectangles. One is only in the list of lights, the other is only a surface.
// Light sampling finds the first rectangle, and hemisphere sampling the second. Their right answers
// differ.
struct HalfLights {
  Situation situation;
  PathSettings settings;
  Rgb expected;
  std::uint64_t seed = 0;
};

inline void showValue(const HalfLights& c, std::ostream& out) {
  showValue(c.situation, out);
  out << fmt::format("\nbounces {} to 1; direct light by {}, samples {}", c.settings.from,
                     c.settings.direct == Direct::lights ? "lights" : "hemisphere",
                     c.settings.light_samples);
}

// Adds lights that bring nothing: they are below the horizon.
inline void lights_below(SceneMaker& maker, int lights) {
  for (int i = 0; i < lights; ++i) maker.directional_light({0, 0, -1}, pt::gray(1));
}

inline rc::Gen<HalfLights> under_half_lights(const rc::Gen<Direct>& way) {
  return rc::gen::exec([=] {
    SceneMaker maker({});
    const Rectangle left{{-1, 0, 1}, {0, 1, 0}, {1, 0, 0}}, right{{1, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    const Rgb of_left = *color(1, 4), of_right = *color(5, 9);
    maker.rectangle(left, of_left, Body::none).surface(right, {}, of_right);
    // The samples are for each light, however many are in the list.
    const Direct direct = *way;
    lights_below(maker, direct == Direct::hemisphere ? 39 : 4);
    HalfLights c{maker.patch(*color(0.1, 1), *direction_above()).done(), {}, {}, *sampler_seed()};
    c.settings = settings_of({*whole(0, 1), 1}, direct);
    c.settings.light_samples = *rc::gen::element(1, 2, 8, 40);
    c.expected = c.situation.expected;
    if (c.settings.direct == Direct::hemisphere) {
      c.expected = c.situation.point.albedo * of_right / pt::kPi *
                   cosine_of_polygon(right.corners(), {}, {0, 0, 1});
    }
    return c;
  });
}

// Makes the same room every time: the generator runs with a fixed seed.
inline Room made(const rc::Gen<Room>& rooms, std::uint64_t seed) {
  return rooms(rc::Random(seed), rc::kNominalSize).value();
}

// Returns a round room with its light in the middle. The direct light is the albedo at every point.
inline Room lit_from_the_middle(Room room) {
  const pt::Sphere ball = room.scene.primitives.spheres[0];
  room.scene.lights = {pt::PointLight{ball.center, ball.radius * ball.radius * pt::gray(pt::kPi)}};
  return room;
}

// Adds the walls of a box, in different colours, and a point light in it. The box is closed and glows
// a little, or two of its sides are open to a sky.
inline void colored_walls(SceneMaker& maker, bool open, Rgb light) {
  constexpr Rgb kColors[] = {{.9, .3, .3}, {.2, .8, .3}, {.3, .4, .9}, {.8, .8, .1}, {.1, .7, .9}};
  const std::vector<Rectangle> sides = cube();
  for (std::size_t i = open ? 2 : 0; i < std::size(kColors); ++i) {
    maker.surface(sides[i], kColors[i], open ? Rgb{} : Rgb{0.1, 0.2, 0.1});
  }
  if (open) maker.sky(light);
  maker.point_light({0.4, 0.3, 0.5}, light);
}

// Adds a low wall, and two suns that light it.
inline void low_wall(SceneMaker& maker, Rgb albedo, Rgb emission, Rgb irradiance) {
  maker.directional_light({-0.6, 0, 0.8}, irradiance).directional_light({-0.8, 0, 0.6}, irradiance);
  maker.surface({{0.6, 0, 0.2}, {0, 0, 0.4}, {0, 2.4, 0}}, albedo, emission);
}

}  // namespace grader::check::trace_path_inputs
