#include "view/worker/tree.h"

#include "view/worker/json.h"

#include <algorithm>

namespace view {

using nlohmann::json;

namespace {

constexpr std::size_t kMostNodes = 20000;  // that are drawn

double area(const pt::Box& box) {
  const pt::Vec3 e = box.extent();
  return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

}  // namespace

json tree_of(const pt::Bvh& bvh) {
  const auto count = static_cast<int>(bvh.nodes.size());
  std::vector<int> level(bvh.nodes.size(), -1);
  std::vector<char> is_right(bvh.nodes.size(), 0);
  if (count > 0) level[0] = 0;
  json nodes = json::array();
  int depth = 0, leaves = 0, largest = 0;
  double boxes = 1, primitives = 0;
  for (int i = 0; i < count; ++i) {
    if (level[i] < 0) continue;  // not below the root
    const pt::BvhNode& node = bvh.nodes[i];
    const double part = area(node.box) / area(bvh.nodes[0].box);
    depth = std::max(depth, level[i]);
    if (node.is_leaf()) {
      ++leaves;
      largest = std::max(largest, node.count);
      primitives += part * node.count;
    } else {
      boxes += 2 * part;
      for (const int child : {node.left, node.right}) {
        if (child <= i || child >= count) continue;
        level[child] = level[i] + 1;
        is_right[child] = child == node.right;
      }
    }
    if (nodes.size() < kMostNodes) {
      nodes.push_back({to_json(node.box.min), to_json(node.box.max), level[i],
                       static_cast<int>(is_right[i]), node.is_leaf() ? node.count : 0});
    }
  }
  return {{"nodes", std::move(nodes)},
          {"count", count},
          {"depth", depth},
          {"leaves", leaves},
          {"largest", largest},
          {"boxes", to_json(boxes)},
          {"primitives", to_json(primitives)}};
}

}  // namespace view
