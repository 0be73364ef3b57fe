#include "pt/render/pixel_record.h"
#include "pt/render/render_apart.h"
#include "tests/proof/one_walk.h"

#include <gtest/gtest.h>

// This trace_path adds the emission of surfaces that the path hits. This is not the direct light of
// a bounce, so its pictures cannot come from one walk, and the walk reports that.

namespace pt::proof {
namespace {

TEST(PixelApart, is_not_complete_where_the_sum_holds_more_than_direct_light) {
  SceneBuilder builder;
  builder.room({-1, -0.5, -2}, {1, 1, 1.5}, builder.material({.5, .5, .5}, {2, 1, .5}));
  builder.light(mesh_light(builder.triangles(), {2, 1, .5}));
  const Scene scene = builder.finish(Engine::task);
  Camera camera;
  camera.position = {0, .2, 1};
  const View view{scene, camera, settings_up_to(2, Direct::hemisphere), 4, 3};
  const std::vector<BounceRange> ranges{{0, 2}, {1, 1}};
  EXPECT_FALSE(render_pixel_apart(view, 1, 1, {256, {}, 4, 1}, ranges).complete);
}

}  // namespace
}  // namespace pt::proof
