#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <deque>
#include <numeric>
#include <vector>
namespace pt {
// Swept surface area heuristic, breadth first with a queue.
namespace {
double area(const Box& b) {
  if (b.is_empty()) return 0;
  Vec3 e = b.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}
struct Work {
  int node, first, last;
};
struct Split {
  int axis = 0, at;
};
// of the boxes of `range`; halves where all costs are infinite
Split best_split(std::span<const Box> boxes, std::span<const int> range) {
  int n = int(range.size());
  double best = kInfinity;
  Split found{0, n / 2};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<int> order(range.begin(), range.end());
    std::ranges::stable_sort(order, {}, [&](int i) { return boxes[i].center()[axis]; });
    std::vector<double> right(n);
    Box b;
    for (int i = n - 1; i > 0; --i) {
      b.grow(boxes[order[i]]);
      right[i] = area(b);
    }
    Box l;
    for (int i = 1; i < n; ++i) {
      l.grow(boxes[order[i - 1]]);
      double cost = area(l) * i + right[i] * (n - i);
      if (cost < best) {
        best = cost;
        found = {axis, i};
      }
    }
  }
  return found;
}
}  // namespace
Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh bvh;
  if (boxes.empty()) return bvh;
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  bvh.nodes.push_back({});
  std::deque<Work> queue{{0, 0, int(boxes.size())}};
  while (!queue.empty()) {
    auto [node, first, last] = queue.front();
    queue.pop_front();
    Box box;
    for (int i = first; i < last; ++i) box.grow(boxes[bvh.order[i]]);
    bvh.nodes[node].box = box;
    int n = last - first;
    if (n <= max_leaf) {
      bvh.nodes[node].first = first;
      bvh.nodes[node].count = n;
      continue;
    }
    auto split = best_split(boxes, std::span(bvh.order).subspan(first, n));
    // equal costs everywhere (identical or flat boxes): halves
    std::stable_sort(bvh.order.begin() + first, bvh.order.begin() + last, [&](int a, int c) {
      return boxes[a].center()[split.axis] < boxes[c].center()[split.axis];
    });
    int left = int(bvh.nodes.size());
    bvh.nodes.resize(left + 2);
    bvh.nodes[node].left = left;
    bvh.nodes[node].right = left + 1;
    queue.push_back({left, first, first + split.at});
    queue.push_back({left + 1, first + split.at, last});
  }
  return bvh;
}
}  // namespace pt
