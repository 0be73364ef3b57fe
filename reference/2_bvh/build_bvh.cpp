#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <bit>
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
  // returns where those of the right child begin, which is never at either end.
  int partition(int first, int last, bool by_plane) {
    Box centroids;
    for (int i = first; i < last; ++i) centroids.grow(boxes[bvh.order[i]].center());
    const int axis = longest_axis(centroids.extent());
    const auto position = [&](int i) { return boxes[i].center()[axis]; };

    const auto begin = bvh.order.begin() + first;
    const auto end = bvh.order.begin() + last;
    if (by_plane) {
      const double middle = centroids.center()[axis];
      const auto split = std::partition(begin, end, [&](int i) { return position(i) < middle; });
      if (split != begin && split != end) return first + static_cast<int>(split - begin);
    }
    // There is no plane, or all centroids are on one side of it, because they are equal or nearly
    // equal. The median always divides the range.
    const auto median = begin + (last - first) / 2;
    std::nth_element(begin, median, end, [&](int i, int j) { return position(i) < position(j); });
    return first + (last - first) / 2;
  }

  // Makes nodes[index] the root of a tree over order[first .. last). The two children are next to
  // each other in memory, because a ray is tested against both. A node is known by its index, never
  // by a reference, because new nodes may move all nodes.
  //
  // Planes follow the shape of a scene. But if the centroids are at 2^-i, each plane cuts off only
  // one of them. So below `planes` levels the median divides a range, which keeps the tree shallow.
  void build(int index, int first, int last, int planes) {
    for (int i = first; i < last; ++i) bvh.nodes[index].box.grow(boxes[bvh.order[i]]);
    if (last - first <= max_leaf) {
      bvh.nodes[index].first = first;
      bvh.nodes[index].count = last - first;
      return;
    }
    const int middle = partition(first, last, planes > 0);
    const int left = static_cast<int>(bvh.nodes.size());
    const int right = left + 1;
    bvh.nodes.resize(bvh.nodes.size() + 2);
    bvh.nodes[index].left = left;
    bvh.nodes[index].right = right;
    build(left, first, middle, planes - 1);
    build(right, middle, last, planes - 1);
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Builder builder{boxes, max_leaf, {}};
  builder.bvh.order.resize(boxes.size());
  std::iota(builder.bvh.order.begin(), builder.bvh.order.end(), 0);
  if (boxes.empty()) return builder.bvh;
  builder.bvh.nodes.resize(1);
  // This is twice the depth of a balanced tree.
  const int planes = 2 * static_cast<int>(std::bit_width(boxes.size()));
  builder.build(0, 0, static_cast<int>(boxes.size()), planes);
  return builder.bvh;
}

}  // namespace pt
