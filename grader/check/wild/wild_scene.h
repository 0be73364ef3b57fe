#pragma once

#include "grader/check/generators/random_numbers.h"
#include "grader/check/scenes/scenes.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

// Scenes of any kind that the contracts allow. No closed form is needed where a call is explained (grader/explain), so lights and
// surfaces may hide each other, and sizes, distances and angles are of many orders of magnitude. All is described in local
// coordinates, as in SceneMaker: the point is the origin, and its normal is along z.

namespace grader::check {

struct WildLight {
  enum class Kind { rectangle, ball, cube, point, directional, sky };
  Kind kind = Kind::sky;
  pt::Vec3 at;  // its centre; of a directional light, the direction to it
  pt::Vec3 u,
      v;  // the sides of a rectangle; two edges of a cube, the third one is at a right angle
  double radius = 0;
  pt::Rgb radiance;  // or intensity, or irradiance
  bool has_body = false;
};

// A ball, or a triangle if the radius is 0.
struct WildSurface {
  pt::Vec3 at, p1, p2;
  double radius = 0;
  pt::Rgb albedo, emission;
};

// A closed cube around everything close by.
struct WildRoom {
  pt::Vec3 center;
  double half = 0;
  std::array<pt::Rgb, 6> albedo, emission;
};

struct WildScene {
  double size = 1;
  pt::Vec3 away;                  // from the world's origin, in sizes
  pt::Vec3 up{0, 0, 1};           // the normal in the world
  pt::Vec3 true_normal{0, 0, 1};  // of the surface itself
  double side = 1;                // of the triangle that the point is on
  pt::Rgb albedo, emission;       // of that
  pt::Vec3 wo{0, 0, 1};
  double seen_from = 1;  // the distance
  std::vector<WildLight> lights;
  std::vector<WildSurface> surfaces;
  std::optional<WildRoom> room;
};

// Three in five have a room, if rooms are wanted.
WildScene wild_scene(RandomNumbers& random, bool rooms);

// The scene without its text, and its point as a ray finds it. None if the ray meets something else before.
std::optional<Situation> made(const WildScene& scene);

// The scene in words, one line per object.
std::string text_of(const WildScene& scene);

// Scenes with one thing less, or one number that is simpler.
std::vector<WildScene> smaller(const WildScene& scene);

// A number between low and high, both > 0, on a logarithmic scale.
double by_size(RandomNumbers& random, double low, double high);

inline bool by_chance(RandomNumbers& random, double probability) {
  return random.between(0, 1) < probability;
}

}  // namespace grader::check
