#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

namespace {

int longest_axis(Vec3 extent) {
  int axis = 0;
  if (extent.y > extent[axis]) axis = 1;
  if (extent.z > extent[axis]) axis = 2;
  return axis;
}

struct Builder {
  std::span<const Box> boxes;
  int max_leaf;
  Bvh bvh;

  // Moves the primitives order[first .. last) that belong to the left child to the front, and
  // returns where the right ones begin; never at either end.
  int partition(int first, int last) {
    Box centroids;
    for (int i = first; i < last; ++i) centroids.grow(boxes[bvh.order[i]].center());
    const int axis = longest_axis(centroids.extent());
    const double middle = centroids.center()[axis];

    const auto begin = bvh.order.begin() + first;
    const auto end = bvh.order.begin() + last;
    const auto split =
        std::partition(begin, end, [&](int i) { return boxes[i].center()[axis] < middle; });
    if (split != begin && split != end) return first + static_cast<int>(split - begin);

    // All centroids are on one side, so they are identical (or as good as): any half will do.
    return first + (last - first) / 2;
  }

  // Makes nodes[index] the root of a tree over order[first .. last). Its children are made next to
  // each other, since whoever looks at one looks at the other too. A node is reached by its index,
  // never by a reference, because new nodes may move all of them.
  void build(int index, int first, int last) {
    for (int i = first; i < last; ++i) bvh.nodes[index].box.grow(boxes[bvh.order[i]]);
    if (last - first <= max_leaf) {
      bvh.nodes[index].first = first;
      bvh.nodes[index].count = last - first;
      return;
    }
    const int middle = partition(first, last);
    const int left = static_cast<int>(bvh.nodes.size());
    const int right = left + 1;
    bvh.nodes.resize(bvh.nodes.size() + 2);
    bvh.nodes[index].left = left;
    bvh.nodes[index].right = right;
    build(left, first, middle);
    build(right, middle, last);
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Builder builder{boxes, max_leaf, {}};
  builder.bvh.order.resize(boxes.size());
  std::iota(builder.bvh.order.begin(), builder.bvh.order.end(), 0);
  if (boxes.empty()) return builder.bvh;
  builder.bvh.nodes.resize(1);
  builder.build(0, 0, static_cast<int>(boxes.size()));
  return builder.bvh;
}

}  // namespace pt
