#pragma once

#include "pt/accel/binary_tree.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pt {

// Chooses the binary nodes that become the children of each wide node, and those that become blocks
// of up to W primitives. This choice makes the total cost of all wide nodes and blocks as small as
// possible (Ylitie, Karras and Laine 2017, Efficient Incoherent Ray Traversal on GPUs Through
// Compressed Wide BVHs, section 3.1). The subtree below a binary node may fill several slots of the
// wide node above; its cost follows from the costs of its two children, which share these slots.
template <int W>
class ChildChoice {
 public:
  explicit ChildChoice(const BinaryTree& binary) : binary_(binary), left_(binary.nodes.size()) {
    if (!left_.empty()) least_cost(0);
  }

  bool is_block(std::uint32_t node) const { return left_[node][0] == kBlock; }

  struct Children {
    std::array<std::uint32_t, W> node{};
    int count = 0;
  };
  Children of(std::uint32_t parent) const {
    Children children;
    split(parent, W, children);
    return children;
  }

 private:
  using Costs = std::array<float, W>;  // entry s - 1 is for s slots
  static constexpr std::uint8_t kBlock = 0xff;

  // The costs of a subtree, those of its own node or block included.
  Costs least_cost(std::uint32_t index) {
    const BinaryNode& node = binary_.nodes[index];
    const float own = binary_.cost.of(node.box), block = own + binary_.cost.room;
    auto& lefts = left_[index];
    Costs best;
    if (node.child == 0) {
      best.fill(block);
      lefts[0] = kBlock;
      return best;
    }
    const Costs a = least_cost(node.child), b = least_cost(node.child + 1);
    for (int slots = 2; slots <= W; ++slots) {
      float least = std::numeric_limits<float>::infinity();
      for (int left = 1; left < slots; ++left) {
        const float sum = a[left - 1] + b[slots - left - 1];
        if (!(sum < least)) continue;
        least = sum;
        lefts[slots - 1] = static_cast<std::uint8_t>(left);
      }
      best[slots - 1] = least;
    }
    // In one slot the node is a block or a wide node itself, which may be best with more slots, too.
    best[0] = best[W - 1] + own;
    if (node.count <= W && block <= best[0]) {
      best[0] = block;
      lefts[0] = kBlock;
    }
    for (int slots = 2; slots < W; ++slots) {
      if (!(best[0] < best[slots - 1])) continue;
      best[slots - 1] = best[0];
      lefts[slots - 1] = 0;
    }
    return best;
  }

  void split(std::uint32_t parent, int slots, Children& children) const {
    const int left = left_[parent][slots - 1];
    const std::uint32_t first = binary_.nodes[parent].child;
    place(first, left, children);
    place(first + 1, slots - left, children);
  }
  void place(std::uint32_t node, int slots, Children& children) const {
    if (slots > 1 && left_[node][slots - 1] > 0) return split(node, slots, children);
    children.node[children.count++] = node;
  }

  const BinaryTree& binary_;
  // For each node, and each number of slots less one, the slots of the first child; 0 where the node
  // takes one slot.
  std::vector<std::array<std::uint8_t, W>> left_;
};

}  // namespace pt
