#include "pt/accel/collapse.h"

#include "pt/accel/child_choice.h"

#include <algorithm>
#include <array>
#include <limits>

namespace pt {

namespace {

// For even smaller triangles, products in single precision may underflow. With this size, the error
// bounds are larger than that loss.
constexpr float kSmallest = 0x1p-40f;
constexpr float kSmallestArea = kSmallest * kSmallest;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

double sum_abs(Vec3 a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }

template <int W>
void put(float (&rows)[3][W], int slot, Vec3 a) {
  for (int axis = 0; axis < 3; ++axis) rows[axis][slot] = static_cast<float>(a[axis]);
}

// Differences are computed before they are scaled, so that corners far from the centre lose no
// digits.
template <int W>
void put(WideBlock<W>& block, int slot, const Triangle& triangle, const WideFrame& frame) {
  const Vec3 e1 = (triangle.p0 - triangle.p1) * frame.scale;
  const Vec3 e2 = (triangle.p2 - triangle.p0) * frame.scale;
  const double longer = std::max(sum_abs(e1), sum_abs(e2));
  put(block.p0, slot, frame(triangle.p0));
  put(block.e1, slot, e1);
  put(block.e2, slot, e2);
  block.size[slot] = std::max(kSmallest, static_cast<float>(longer + longer * longer / 4));
  const double products = sum_abs(e1) * sum_abs(e2) - std::abs(e1.x * e2.x) -
                          std::abs(e1.y * e2.y) - std::abs(e1.z * e2.z);
  // In a sliver, what exact_hit moves a corner by may be more than both.
  const double area = length(cross(e1, e2)) + products / 4 + 0x1p-24 * longer * longer;
  block.area[slot] = std::max(kSmallestArea, static_cast<float>(1.0001 * area));
}

template <int W>
WideBlock<W> empty_block() {
  WideBlock<W> block;
  for (int slot = 0; slot < W; ++slot) {
    const Vec3 none{kNone, kNone, kNone};
    put(block.p0, slot, none);
    put(block.e1, slot, none);
    put(block.e2, slot, none);
    block.size[slot] = kNone;
    block.area[slot] = kNone;
    block.primitive[slot] = kNothing;
  }
  return block;
}

template <int W>
void put(WideBlock<W>& block, int slot, const Sphere& sphere, const WideFrame& frame) {
  put(block.p0, slot, frame(sphere.center));
  put(block.e1, slot, {sphere.radius * frame.scale, 0, 0});
  put(block.e2, slot, {});
  block.size[slot] = kSphere;
  block.area[slot] = 0;
}

template <int W>
WideBlock<W> make_block(const BinaryTree& binary, const BinaryNode& leaf,
                        const Primitives& primitives, const WideFrame& frame) {
  WideBlock<W> block = empty_block<W>();
  int slot = 0;
  for (const bool triangles : {false, true}) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t primitive = binary.primitives[i].primitive;
      const int index = static_cast<int>(primitive);
      if (primitives.is_triangle(index) != triangles) continue;
      block.primitive[slot] = primitive;
      if (triangles) {
        put(block, slot, primitives.triangle(index), frame);
      } else {
        put(block, slot, primitives.sphere(index), frame);
      }
      ++slot;
    }
  }
  return block;
}

template <int W>
struct Collapsing {
  const BinaryTree& binary;
  const Primitives& primitives;
  const WideFrame& frame;
  ChildChoice<W> choice;
  WideTree<W> wide;

  WideRef add_block(const BinaryNode& leaf) {
    wide.blocks.push_back(make_block<W>(binary, leaf, primitives, frame));
    return kLeaf | static_cast<WideRef>(wide.blocks.size() - 1);
  }

  // The new node is reached by index, because its children's push_back may move it.
  WideRef add(std::uint32_t from) {
    if (choice.is_block(from)) return add_block(binary.nodes[from]);
    const auto children = choice.of(from);
    const auto index = static_cast<WideRef>(wide.nodes.size());
    wide.nodes.emplace_back();
    for (int i = 0; i < W; ++i) {
      const FloatBox box = i < children.count ? binary.nodes[children.node[i]].box : FloatBox{};
      for (int axis = 0; axis < 3; ++axis) {
        wide.nodes[index].bounds[axis][i] = box.min[axis];
        wide.nodes[index].bounds[axis + 3][i] = box.max[axis];
      }
      const WideRef child = i < children.count ? add(children.node[i]) : kNothing;
      wide.nodes[index].child[i] = child;
    }
    return index;
  }
};

}  // namespace

template <int W>
WideTree<W> collapse(const BinaryTree& binary, const Primitives& primitives,
                     const WideFrame& frame) {
  Collapsing<W> collapsing{binary, primitives, frame, ChildChoice<W>(binary), {}};
  if (!binary.nodes.empty()) collapsing.wide.root = collapsing.add(0);
  collapsing.wide.nodes.shrink_to_fit();
  collapsing.wide.blocks.shrink_to_fit();
  return std::move(collapsing.wide);
}

template WideTree<8> collapse<8>(const BinaryTree&, const Primitives&, const WideFrame&);
template WideTree<16> collapse<16>(const BinaryTree&, const Primitives&, const WideFrame&);

}  // namespace pt
