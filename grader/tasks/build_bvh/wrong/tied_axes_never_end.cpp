#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

namespace {

struct Builder {
  std::span<const Box> boxes;
  int max_leaf;
  Bvh bvh;

  int axis_of(const Box& centroids) {
    const Vec3 size = centroids.extent();
    if (size.x > size.y && size.x > size.z) return 0;
    if (size.y > size.x && size.y > size.z) return 1;
    if (size.z > size.x && size.z > size.y) return 2;
    return -1;
  }

  int split(int first, int last) {
    Box centroids;
    for (int i = first; i < last; ++i) centroids.grow(boxes[bvh.order[i]].center());
    const int axis = axis_of(centroids);
    if (axis < 0 && centroids.extent().x > 0) return first;
    const double middle = centroids.center()[std::max(axis, 0)];
    const auto begin = bvh.order.begin();
    const auto cut = std::partition(begin + first, begin + last,
                                    [&](int i) { return boxes[i].center()[axis] < middle; });
    const int at = static_cast<int>(cut - begin);
    if (at == first || at == last) return (first + last) / 2;
    return at;
  }

  int build(int first, int last) {
    const int me = static_cast<int>(bvh.nodes.size());
    bvh.nodes.push_back({});
    Box box;
    for (int i = first; i < last; ++i) box.grow(boxes[bvh.order[i]]);
    bvh.nodes[me].box = box;
    if (last - first <= max_leaf) {
      bvh.nodes[me].first = first;
      bvh.nodes[me].count = last - first;
      return me;
    }
    const int at = split(first, last);
    const int left = build(first, at);
    const int right = build(at, last);
    bvh.nodes[me].left = left;
    bvh.nodes[me].right = right;
    return me;
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
