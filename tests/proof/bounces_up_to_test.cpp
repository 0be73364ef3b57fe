#include "pt/tasks/trace_path.h"
#include "tests/proof/one_walk.h"

#include <gtest/gtest.h>

// Below the cap, the reference's path does not depend on it: the split walk up to bounce m equals
// the walk that stops at m, bit for bit.

namespace pt::proof {
namespace {

const std::vector<BounceRange> kSingle{{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 40}};

TEST(BouncesApart, up_to_m_are_a_walk_of_m_bounces) {
  const Scene scene = yard();
  const SurfacePoint point = point_seen(scene, {1, 3, 6}, {1, 0, 1});
  Sampler sampler(9);
  for (int i = 0; i < 3000; ++i) {
    const Sampler before = sampler;
    const PathSettings whole = settings_up_to(40, Direct::lights);
    const BouncesApart apart = trace_path_apart(scene, point, whole, kSingle, sampler);
    for (std::size_t pieces = 1; pieces <= kSingle.size(); ++pieces) {
      Sampler same = before;
      const PathSettings settings = settings_up_to(kSingle[pieces - 1].to, Direct::lights);
      const Rgb alone = trace_path(scene, point, settings, same);
      ASSERT_EQ(sum_of(apart, pieces), alone) << "m = " << settings.to;
    }
  }
}

}  // namespace
}  // namespace pt::proof
