#pragma once

#include "grader/property/scenes.h"

// Scenes for light that bounces more than once, each with the radiance that leaves one of its
// points after exactly k bounces, by closed forms.

namespace grader {

struct Room {
  pt::Scene scene;
  pt::SurfacePoint point;
  std::vector<pt::Rgb> bounce;  // [k], k from 0 (emission, left black) to kMostBounces
  std::string text;

  pt::Rgb sum(int from, int to) const;  // 1 <= from, to <= kMostBounces
};
void showValue(const Room& room, std::ostream& out);

inline constexpr int kMostBounces = 8;

// Inside one ball, with a point light off its middle. From any patch of a sphere every other one of
// the same area looks as large, so what bounces once is spread evenly over all of it, and each
// further bounce leaves the albedo of it.
rc::Gen<Room> round_room(const rc::Gen<pt::Rgb>& albedo);

// Inside a ball whose middle is a smaller, glowing ball, both as a surface and in the list of
// lights. The point is on either.
rc::Gen<Room> room_around_a_lamp(const rc::Gen<pt::Rgb>& albedo);

// A furnace: all walls of a cube glow and reflect alike. No light is in the list.
rc::Gen<Room> glowing_room(const rc::Gen<pt::Rgb>& albedo);

// A wall in the sun, seen by a point that is on no surface of the scene: only the second bounce
// brings light, or the first by the sun itself (left black in `bounce`), and no path goes further.
rc::Gen<Room> sunny_wall(const rc::Gen<pt::Rgb>& albedo);

}  // namespace grader
