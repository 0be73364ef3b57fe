#pragma once

#include "pt/accel/binary_tree.h"
#include "pt/accel/huge_pages.h"
#include "pt/accel/wide_tree.h"
#include "pt/geometry/primitives.h"

namespace pt {

// The tree's frame: p is at (p - center) * scale there.
struct WideFrame {
  Vec3 center;
  double scale = 1;

  Vec3 operator()(Vec3 p) const { return (p - center) * scale; }
};

// A wide tree as it is built.
template <int W>
struct WideTree {
  HugeVector<WideNode<W>> nodes;
  HugeVector<WideBlock<W>> blocks;
  WideRef root = kNothing;
};

// Makes the wide nodes and the blocks that child_choice.h chooses, with copies of the primitives. W is 8 or 16.
template <int W>
WideTree<W> collapse(const BinaryTree& binary, const Primitives& primitives,
                     const WideFrame& frame);

}  // namespace pt
