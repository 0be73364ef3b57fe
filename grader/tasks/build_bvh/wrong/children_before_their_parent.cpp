#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

namespace {

int build(Bvh& bvh, std::span<const Box> boxes, int first, int last, int max_leaf) {
  BvhNode node;
  Box centroids;
  for (int i = first; i < last; ++i) {
    node.box.grow(boxes[bvh.order[i]]);
    centroids.grow(boxes[bvh.order[i]].center());
  }
  if (last - first <= max_leaf) {
    node.first = first;
    node.count = last - first;
  } else {
    const Vec3 size = centroids.extent();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int middle = (first + last) / 2;
    const auto begin = bvh.order.begin();
    std::nth_element(begin + first, begin + middle, begin + last, [&](int a, int b) {
      return boxes[a].center()[axis] < boxes[b].center()[axis];
    });
    node.left = build(bvh, boxes, first, middle, max_leaf);
    node.right = build(bvh, boxes, middle, last, max_leaf);
  }
  bvh.nodes.push_back(node);
  return static_cast<int>(bvh.nodes.size()) - 1;
}

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh bvh;
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  if (!boxes.empty()) build(bvh, boxes, 0, static_cast<int>(boxes.size()), max_leaf);
  return bvh;
}

}  // namespace pt
