#pragma once

#include <cstddef>
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
  float volume() const { return (max[0] - min[0]) * (max[1] - min[1]) * (max[2] - min[2]); }
};

struct BoxedPrimitive {
  FloatBox box;
  std::uint32_t primitive = 0;
};

// The subtree of primitives[first .. first + count). An inner node has the children nodes[child] and
// nodes[child + 1]; in a leaf, `child` is 0.
struct BinaryNode {
  FloatBox box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t child = 0;
};

// The cost of a node or a block: how likely a ray is to visit it. Rays from outside enter boxes in
// proportion to their area; rays that start anywhere in the scene start in them in proportion to
// their volume. The cost is the sum of both. By area alone, the walls of a room would share a block:
// its box is the room's, and every ray would test it.
struct TreeCost {
  float volume_weight = 0;  // makes area and volume of the whole scene cost the same
  float room = 0;           // for the memory of a block, however few rays visit it

  TreeCost() = default;
  TreeCost(const FloatBox& all, std::size_t primitives) {
    constexpr float kLeast = 0x1p-60f;  // a smaller volume counts as none
    volume_weight = all.half_area() / (all.volume() > kLeast ? all.volume() : kLeast);
    room = 16 * of(all) / static_cast<float>(primitives);
  }
  float of(const FloatBox& box) const { return box.half_area() + volume_weight * box.volume(); }
};

// A binary tree by the surface area heuristic in bins (Wald 2007, On Fast Construction of SAH-based
// Bounding Volume Hierarchies). nodes[0] is the root. Without primitives there are no nodes.
struct BinaryTree {
  std::vector<BinaryNode> nodes;
  std::vector<BoxedPrimitive> primitives;  // in the order of the leaves
  TreeCost cost;
};

// No branch is longer than kMaxTreeDepth, whatever the boxes are. A leaf holds one primitive, or at
// most `block` for which two blocks would certainly cost more than one. The same primitives in the
// same order give the same tree.
BinaryTree build_binary_tree(std::vector<BoxedPrimitive> primitives, int block);

}  // namespace pt
