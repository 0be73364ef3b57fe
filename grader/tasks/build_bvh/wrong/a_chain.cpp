#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

Bvh build_bvh(std::span<const Box> boxes, int) {
  Bvh bvh;
  const int n = static_cast<int>(boxes.size());
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  for (int i = 0; i < n; ++i) {
    if (i < n - 1) {
      const int me = static_cast<int>(bvh.nodes.size());
      BvhNode inner{{}, me + 1, me + 2, 0, 0};
      for (int k = i; k < n; ++k) inner.box.grow(boxes[k]);
      bvh.nodes.push_back(inner);
    }
    bvh.nodes.push_back({boxes[i], -1, -1, i, 1});
  }
  return bvh;
}

}  // namespace pt
