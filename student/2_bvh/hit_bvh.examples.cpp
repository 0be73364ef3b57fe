#include "pt/tasks/hit_bvh.h"

#include "pt/examples/example.h"
#include "pt/tasks/build_bvh.h"

using namespace pt;

// Three spheres of radius 1 on the z axis, and a tree over them.
const Primitives row{{}, {{{0, 0, 0}, 1}, {{0, 0, -5}, 1}, {{0, 0, -10}, 1}}};
static Bvh tree_over(const Primitives& primitives, int max_leaf) {
  std::vector<Box> boxes(static_cast<std::size_t>(primitives.size()));
  for (int i = 0; i < primitives.size(); ++i) boxes[i] = bounds(primitives, i);
  return build_bvh(boxes, max_leaf);
}

EXAMPLE("the nearest of three") {
  const auto hit = hit_bvh(tree_over(row, 1), row, {{0, 0, 5}, {0, 0, -1}});
  EXPECT(hit);
  NEAR(hit->t, 4);
  EXPECT(hit->primitive == 0);
}

EXAMPLE("from the other end") {}

EXAMPLE("an empty tree") {}

EXAMPLE("something is in the way, in the range") {}
