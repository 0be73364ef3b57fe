#include "pt/tasks/build_bvh.h"
namespace pt {
namespace {
int go(Bvh& b, const Box& all, int lo, int hi, int leaf) {
  const size_t me = b.nodes.size();
  b.nodes.push_back({all, -1, -1, lo, hi - lo});
  if (hi - lo > leaf) {
    const int m = (lo + hi) / 2, l = go(b, all, lo, m, leaf), r = go(b, all, m, hi, leaf);
    b.nodes[me] = {all, l, r, 0, 0};
  }
  return int(me);
}
}  // namespace
Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh b;
  Box all;
  for (int i = 0; i < int(boxes.size()); ++i) {
    b.order.push_back(i);
    all.grow(boxes[size_t(i)]);
  }
  if (!boxes.empty()) go(b, all, 0, int(boxes.size()), max_leaf);
  return b;
}
}  // namespace pt
