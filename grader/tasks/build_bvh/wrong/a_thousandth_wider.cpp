#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

namespace {

Box wider(Box box) {
  const Vec3 more = 1e-3 * box.extent();
  return {box.min - more, box.max + more};
}

struct Builder {
  std::span<const Box> boxes;
  int max_leaf;
  Bvh bvh{};

  void build(int index, int first, int last) {
    Box box, centers;
    for (int i = first; i < last; ++i) {
      box.grow(boxes[bvh.order[i]]);
      centers.grow(boxes[bvh.order[i]].center());
    }
    bvh.nodes[index].box = wider(box);
    if (last - first <= max_leaf) {
      bvh.nodes[index].first = first;
      bvh.nodes[index].count = last - first;
      return;
    }
    const Vec3 size = centers.extent();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int middle = first + (last - first) / 2;
    const auto order = bvh.order.begin();
    std::nth_element(order + first, order + middle, order + last, [&](int i, int j) {
      return boxes[i].center()[axis] < boxes[j].center()[axis];
    });
    const int left = static_cast<int>(bvh.nodes.size());
    bvh.nodes.resize(left + 2);
    bvh.nodes[index].left = left;
    bvh.nodes[index].right = left + 1;
    build(left, first, middle);
    build(left + 1, middle, last);
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  if (boxes.empty()) return {};
  Builder builder{boxes, max_leaf};
  builder.bvh.order.resize(boxes.size());
  std::iota(builder.bvh.order.begin(), builder.bvh.order.end(), 0);
  builder.bvh.nodes.resize(1);
  builder.build(0, 0, static_cast<int>(boxes.size()));
  return builder.bvh;
}

}  // namespace pt
