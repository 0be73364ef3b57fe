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
    double best = kInfinity;
    int best_axis = 0, best_split = n / 2;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<int> order(bvh.order.begin() + first, bvh.order.begin() + last);
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
          best_axis = axis;
          best_split = i;
        }
      }
    }
    // equal costs everywhere (identical or flat boxes): halves
    std::stable_sort(bvh.order.begin() + first, bvh.order.begin() + last, [&](int a, int c) {
      return boxes[a].center()[best_axis] < boxes[c].center()[best_axis];
    });
    int left = int(bvh.nodes.size());
    bvh.nodes.resize(left + 2);
    bvh.nodes[node].left = left;
    bvh.nodes[node].right = left + 1;
    queue.push_back({left, first, first + best_split});
    queue.push_back({left + 1, first + best_split, last});
  }
  return bvh;
}
}  // namespace pt
