#pragma once

#include <cstdint>
#include <vector>

namespace pt {

// A box in single precision, in the frame of a WideTree. A new box is empty.
struct FloatBox {
  float min[3] = {__builtin_inff(), __builtin_inff(), __builtin_inff()};
  float max[3] = {-__builtin_inff(), -__builtin_inff(), -__builtin_inff()};

  void grow(const FloatBox& other) {
    for (int a = 0; a < 3; ++a) {
      min[a] = other.min[a] < min[a] ? other.min[a] : min[a];
      max[a] = other.max[a] > max[a] ? other.max[a] : max[a];
    }
  }
  float half_area() const {
    const float x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

struct BoxedPrimitive {
  FloatBox box;
  std::uint32_t primitive = 0;
};

// A leaf holds primitives[first .. first + count); an inner node has the children nodes[first] and
// nodes[first + 1], and count is 0.
struct BinaryNode {
  FloatBox box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

// A binary tree by the surface area heuristic in bins (Wald 2007, On Fast Construction of SAH-based
// Bounding Volume Hierarchies). nodes[0] is the root. Without primitives there are no nodes.
struct BinaryTree {
  std::vector<BinaryNode> nodes;
  std::vector<BoxedPrimitive> primitives;  // in the order of the leaves
};

// No branch is longer than kMaxTreeDepth, whatever the boxes are. Leaves hold at most `block`
// primitives; a full leaf costs as much to test as any other. The same primitives in the same order
// give the same tree.
BinaryTree build_binary_tree(std::vector<BoxedPrimitive> primitives, int block);

}  // namespace pt
