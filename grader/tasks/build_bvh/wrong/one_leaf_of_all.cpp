#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

Bvh build_bvh(std::span<const Box> boxes, int) {
  Bvh bvh;
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  if (boxes.empty()) return bvh;
  BvhNode root;
  for (const Box& box : boxes) root.box.grow(box);
  root.count = static_cast<int>(boxes.size());
  bvh.nodes.push_back(root);
  return bvh;
}

}  // namespace pt
