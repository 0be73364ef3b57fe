#pragma once

#include "pt/accel/binary_tree.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pt {

// Chooses the binary nodes that become the children of each wide node. This choice makes the total
// area of all wide nodes, and so the number of nodes that a ray visits, as small as possible
// (Ylitie, Karras and Laine 2017, Efficient Incoherent Ray Traversal on GPUs Through Compressed
// Wide BVHs, section 3.1). The subtree below a binary node may fill several slots of the wide node
// above; its cost follows from the costs of its two children, which share these slots.
template <int W>
class ChildChoice {
 public:
  explicit ChildChoice(const BinaryTree& binary) : binary_(binary), shares_(binary.nodes.size()) {
    // Children come after their parents.
    for (std::size_t i = shares_.size(); i-- > 0;) {
      if (binary.nodes[i].count == 0) shares_[i] = share(binary.nodes[i]);
    }
  }

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
  // Entry s - 1 is for s slots. A leaf costs nothing, whatever the number of slots.
  struct Share {
    std::array<float, W> area{};         // of the wide nodes, those below included
    std::array<std::uint8_t, W> left{};  // slots of the first child; 0 where the node takes one
  };

  Share share(const BinaryNode& node) const {
    const Share& a = shares_[node.first];
    const Share& b = shares_[node.first + 1];
    Share best;
    for (int slots = 2; slots <= W; ++slots) {
      float least = std::numeric_limits<float>::infinity();
      for (int left = 1; left < slots; ++left) {
        const float area = a.area[left - 1] + b.area[slots - left - 1];
        if (!(area < least)) continue;
        least = area;
        best.left[slots - 1] = static_cast<std::uint8_t>(left);
      }
      best.area[slots - 1] = least;
    }
    // In one slot the node is a wide node itself, which may be best with more slots, too.
    best.area[0] = best.area[W - 1] + node.box.half_area();
    for (int slots = 2; slots < W; ++slots) {
      if (!(best.area[0] < best.area[slots - 1])) continue;
      best.area[slots - 1] = best.area[0];
      best.left[slots - 1] = 0;
    }
    return best;
  }

  void split(std::uint32_t parent, int slots, Children& children) const {
    const int left = shares_[parent].left[slots - 1];
    const std::uint32_t first = binary_.nodes[parent].first;
    place(first, left, children);
    place(first + 1, slots - left, children);
  }
  void place(std::uint32_t node, int slots, Children& children) const {
    if (slots > 1 && shares_[node].left[slots - 1] > 0) return split(node, slots, children);
    children.node[children.count++] = node;
  }

  const BinaryTree& binary_;
  std::vector<Share> shares_;
};

}  // namespace pt
