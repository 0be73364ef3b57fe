#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace pt {
namespace {
struct Job {
  int node, begin, end;
};
}  // namespace
Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh bvh;
  const int n = static_cast<int>(boxes.size());
  if (n == 0) return bvh;
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  for (int& i : bvh.order) i = static_cast<unsigned short>(i);
  bvh.nodes.resize(1);
  std::queue<Job> todo_list;
  todo_list.push({0, 0, n});
  while (!todo_list.empty()) {
    const auto [node, begin, end] = todo_list.front();
    todo_list.pop();
    const int count = end - begin;
    if (count <= max_leaf) {
      bvh.nodes[static_cast<size_t>(node)].first = begin;
      bvh.nodes[static_cast<size_t>(node)].count = count;
      continue;
    }
    const auto first = bvh.order.begin() + begin, last = bvh.order.begin() + end;
    Box c;
    Vec3 mean;
    for (auto it = first; it != last; ++it) {
      const Vec3 m = boxes[static_cast<size_t>(*it)].center();
      c.grow(m);
      mean += m / count;
    }
    const Vec3 e = c.extent();
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    const auto key = [&](int i) { return boxes[static_cast<size_t>(i)].center()[axis]; };
    auto mid = std::partition(first, last, [&](int i) { return key(i) < mean[axis]; });
    if (mid == first || mid == last) {
      std::sort(first, last, [&](int a, int b) { return key(a) < key(b); });
      mid = first + count / 2;
    }
    const int left = static_cast<int>(bvh.nodes.size());
    const int split = static_cast<int>(mid - bvh.order.begin());
    bvh.nodes[static_cast<size_t>(node)].left = left;
    bvh.nodes[static_cast<size_t>(node)].right = left + 1;
    bvh.nodes.resize(bvh.nodes.size() + 2);
    todo_list.push({left, begin, split});
    todo_list.push({left + 1, split, end});
  }
  for (size_t i = bvh.nodes.size(); i-- > 0;) {
    BvhNode& node = bvh.nodes[i];
    if (node.count > 0) {
      for (int k = node.first; k < node.first + node.count; ++k)
        node.box.grow(boxes[static_cast<size_t>(bvh.order[static_cast<size_t>(k)])]);
    } else {
      node.box = bvh.nodes[static_cast<size_t>(node.left)].box;
      node.box.grow(bvh.nodes[static_cast<size_t>(node.right)].box);
    }
  }
  return bvh;
}
}  // namespace pt
