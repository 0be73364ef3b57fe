// right: std::function that calls itself, the median by nth_element, boxes made from below
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

namespace pt {

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh bvh;
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  const std::function<int(int, int)> build = [&](int first, int last) {
    const int me = static_cast<int>(bvh.nodes.size());
    bvh.nodes.push_back({});
    if (last - first <= max_leaf) {
      bvh.nodes[me].first = first;
      bvh.nodes[me].count = last - first;
      for (int i = first; i < last; ++i) bvh.nodes[me].box.grow(boxes[bvh.order[i]]);
      return me;
    }
    Box all;
    for (int i = first; i < last; ++i) all.grow(boxes[bvh.order[i]].center());
    const Vec3 size = all.extent();
    const std::multimap<double, int, std::greater<>> axes{{size.x, 0}, {size.y, 1}, {size.z, 2}};
    const int axis = axes.begin()->second, middle = first + (last - first + 1) / 2;
    std::nth_element(
        bvh.order.begin() + first, bvh.order.begin() + middle, bvh.order.begin() + last,
        [&](int a, int b) { return boxes[a].center()[axis] < boxes[b].center()[axis]; });
    const int right = build(middle, last), left = build(first, middle);
    bvh.nodes[me].left = left;
    bvh.nodes[me].right = right;
    bvh.nodes[me].box.grow(bvh.nodes[left].box);
    bvh.nodes[me].box.grow(bvh.nodes[right].box);
    return me;
  };
  if (!boxes.empty()) build(0, static_cast<int>(boxes.size()));
  return bvh;
}

}  // namespace pt
