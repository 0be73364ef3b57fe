#pragma once

#include "bench/test_scenes.h"
#include "pt/geometry/ray.h"

#include <vector>

namespace pt {

// The rays that a path tracer would trace in a scene, by kind. Shadow rays come in groups of
// kShadowGroup from one point.
inline constexpr int kShadowGroup = 8;
struct RaySets {
  std::vector<Ray> primary;
  std::vector<Ray> bounce;
  std::vector<Ray> shadow;
};

// Makes about `count` rays of each kind with the scene's tracer. Primary rays go through random
// points of the pixels of a 480 x 360 picture, in order. The others start in turn at the hits of
// primary rays, and after one bounce.
RaySets make_rays(const TestScene& test, int count);

}  // namespace pt
