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

// About `count` rays of each kind. The scene's tracer is used. Primary rays are jittered through
// the pixels of a 480 x 360 picture in order; the others start from points met by those or after
// one bounce, by turns.
RaySets make_rays(const TestScene& test, int count);

}  // namespace pt
