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

  // Appends the tree over order[first .. last) and returns the index of its root. The new node is
  // reached by index, because its children's push_back may move it.
  int build(int first, int last) {
    const int index = static_cast<int>(bvh.nodes.size());
    bvh.nodes.emplace_back();
    for (int i = first; i < last; ++i) bvh.nodes[index].box.grow(boxes[bvh.order[i]]);
    if (last - first <= max_leaf) {
      bvh.nodes[index].first = first;
      bvh.nodes[index].count = last - first;
      return index;
    }
    const int middle = partition(first, last);
    const int left = build(first, middle);
    const int right = build(middle, last);
    bvh.nodes[index].left = left;
    bvh.nodes[index].right = right;
    return index;
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Builder builder{boxes, max_leaf, {}};
  builder.bvh.order.resize(boxes.size());
  std::iota(builder.bvh.order.begin(), builder.bvh.order.end(), 0);
  if (!boxes.empty()) builder.build(0, static_cast<int>(boxes.size()));
  return builder.bvh;
}

}  // namespace pt
