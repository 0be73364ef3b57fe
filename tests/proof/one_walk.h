#pragma once

#include "pt/render/bounces_apart.h"
#include "tests/proof/scenes.h"

#include <vector>

// The scene and the ranges that the tests of split bounces share.

namespace pt::proof {

using Direct = PathSettings::Direct;

inline const std::vector<BounceRange> kPieces{{1, 1}, {2, 2}, {3, 5}, {6, 40}};

// A floor, a wall and a sphere under a small lamp: some paths leave, and some points are in shadow.
inline Scene yard() {
  SceneBuilder builder;
  builder.quad({-4, 0, -4}, {0, 0, 8}, {8, 0, 0}, builder.material({.7, .5, .3}));
  builder.quad({-4, 0, -4}, {8, 0, 0}, {0, 6, 0}, builder.material({.3, .6, .8}));
  builder.sphere({0, 1, 0}, 1, builder.material({.8, .8, .8}));
  builder.light(RectangleLight{{0, 5, 1}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {8, 7, 6}});
  return builder.finish(Engine::task);
}

inline PathSettings settings_up_to(int to, Direct direct) {
  PathSettings settings;
  settings.to = to;
  settings.direct = direct;
  return settings;
}

inline Rgb sum_of(const BouncesApart& apart, std::size_t pieces) {
  Rgb sum;
  for (std::size_t i = 0; i < pieces; ++i) sum += apart.ranges[i];
  return sum;
}

}  // namespace pt::proof
