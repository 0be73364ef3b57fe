#include "pt/tasks/build_bvh.h"

#include "pt/examples/example.h"

using namespace pt;

EXAMPLE("two boxes, one in each leaf") {
  const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}}, {{5, 0, 0}, {6, 1, 1}}};
  const Bvh bvh = build_bvh(boxes, 1);
  EXPECT(bvh.nodes.size() == 3);
  EXPECT(bvh.order.size() == 2);
  NEAR(bvh.nodes[0].box.min, {0, 0, 0});
  NEAR(bvh.nodes[0].box.max, {6, 1, 1});
}

EXAMPLE("no boxes") {}

EXAMPLE("more boxes than a leaf may hold") {}

EXAMPLE("many boxes that are all equal") {}
