// right: an explicit std::stack of ranges, and boxes some rounding errors larger than they need to
// be
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stack>

namespace pt {

namespace {

Box wider(Box box) {
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::nextafter(box.min[axis], -kInfinity);
    box.max[axis] = std::nextafter(box.max[axis], kInfinity);
  }
  return box;
}

struct Range {
  int node, first, last;
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh bvh;
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  if (boxes.empty()) return bvh;
  bvh.nodes.resize(1);
  std::stack<Range> open;
  open.push({0, 0, static_cast<int>(boxes.size())});
  while (!open.empty()) {
    const auto [node, first, last] = open.top();
    open.pop();
    Box all, centroids;
    for (int i = first; i < last; ++i) {
      all.grow(boxes[bvh.order[i]]);
      centroids.grow(boxes[bvh.order[i]].center());
    }
    bvh.nodes[node].box = wider(all);
    if (last - first <= max_leaf) {
      bvh.nodes[node].first = first;
      bvh.nodes[node].count = last - first;
      continue;
    }
    const Vec3 size = centroids.extent();
    const int axis = size.z >= std::max(size.x, size.y) ? 2 : size.y >= size.x ? 1 : 0;
    const float plane = static_cast<float>(centroids.center()[axis]);  // any plane will do
    const auto cut = std::stable_partition(bvh.order.begin() + first, bvh.order.begin() + last,
                                           [&](int i) { return boxes[i].center()[axis] > plane; });
    int middle = static_cast<int>(cut - bvh.order.begin());
    if (middle == first || middle == last) middle = first + (last - first) / 2;
    const int left = static_cast<int>(bvh.nodes.size());
    bvh.nodes[node].left = left;
    bvh.nodes[node].right = left + 1;
    bvh.nodes.resize(bvh.nodes.size() + 2);
    open.push({left, first, middle});
    open.push({left + 1, middle, last});
  }
  return bvh;
}

}  // namespace pt
