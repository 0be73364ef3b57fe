// The children of a wide node, compared with every possible choice.
#include "pt/accel/child_choice.h"

#include "pt/sampling/sampler.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

namespace {

using pt::BinaryTree;

constexpr int kWidth = 4;

// A tree with one box per leaf; some boxes are large, some flat, some points.
BinaryTree random_tree(int leaves, pt::Sampler& sampler) {
  std::vector<pt::BoxedPrimitive> boxes(static_cast<std::size_t>(leaves));
  std::uint32_t primitive = 0;
  for (pt::BoxedPrimitive& boxed : boxes) {
    boxed.primitive = primitive++;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = std::max(0.0, sampler.next_1d() - 0.3);
      boxed.box.min[axis] = static_cast<float>(2 * sampler.next_1d() - 1);
      boxed.box.max[axis] = boxed.box.min[axis] + static_cast<float>(size * size);
    }
  }
  return pt::build_binary_tree(std::move(boxes), kWidth);
}

float least_cost(const BinaryTree& tree, std::uint32_t node);

// The smallest cost below any set of children that results from opening inner nodes of this node.
float least_of_sets(const BinaryTree& tree, const std::vector<std::uint32_t>& children) {
  float cost = 0;
  for (const std::uint32_t child : children) cost += least_cost(tree, child);
  if (children.size() == kWidth) return cost;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const pt::BinaryNode& child = tree.nodes[children[i]];
    if (child.child == 0) continue;
    std::vector<std::uint32_t> opened = children;
    opened[i] = child.child;
    opened.push_back(child.child + 1);
    cost = std::min(cost, least_of_sets(tree, opened));
  }
  return cost;
}

float cost_of_block(const BinaryTree& tree, const pt::BinaryNode& node) {
  return tree.cost.of(node.box) + tree.cost.room;
}

// The smallest cost of the wide nodes and blocks at and below a binary node.
float least_cost(const BinaryTree& tree, std::uint32_t node) {
  const pt::BinaryNode& n = tree.nodes[node];
  float least = n.count <= kWidth ? cost_of_block(tree, n) : std::numeric_limits<float>::infinity();
  if (n.child == 0) return least;
  return std::min(least, tree.cost.of(n.box) + least_of_sets(tree, {n.child, n.child + 1}));
}

// The cost of all that was chosen at and below `node`; counts how often each primitive is reached.
float chosen_cost(const BinaryTree& tree, const pt::ChildChoice<kWidth>& choice, std::uint32_t node,
                  std::vector<int>& reached) {
  const pt::BinaryNode& n = tree.nodes[node];
  if (choice.is_block(node)) {
    EXPECT_LE(n.count, kWidth);
    for (std::uint32_t i = n.first; i < n.first + n.count; ++i) ++reached[i];
    return cost_of_block(tree, n);
  }
  const auto children = choice.of(node);
  EXPECT_GE(children.count, 2);
  EXPECT_LE(children.count, kWidth);
  float cost = tree.cost.of(n.box);
  for (int i = 0; i < children.count; ++i) {
    cost += chosen_cost(tree, choice, children.node[i], reached);
  }
  return cost;
}

TEST(ChildChoice, NoOtherChoiceCostsLess) {
  pt::Sampler sampler(4);
  for (int i = 0; i < 300; ++i) {
    const int count = 2 + i % 17;
    BinaryTree tree = random_tree(count, sampler);
    if (i % 2 == 0) tree.cost.room /= 64;  // then blocks need not be full
    std::vector<int> reached(static_cast<std::size_t>(count));
    const float cost = chosen_cost(tree, pt::ChildChoice<kWidth>(tree), 0, reached);
    const float least = least_cost(tree, 0);
    EXPECT_NEAR(cost, least, 1e-5f * least) << count << " primitives, tree " << i;
    EXPECT_EQ(reached, std::vector<int>(static_cast<std::size_t>(count), 1));
  }
}

// The walls of a room: one block of them has a box as large as the room, although its volume is empty.
TEST(ChildChoice, WallsDoNotShareABlockWithTheirRoom) {
  std::vector<pt::BoxedPrimitive> boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      pt::FloatBox wall{{-1, -1, -1}, {1, 1, 1}};
      wall.min[axis] = wall.max[axis] = side;
      boxes.push_back({wall, 0});
    }
  }
  for (int i = 0; i < 1000; ++i) {
    const float x = 0.0005f * static_cast<float>(i);
    boxes.push_back({{{x, 0, 0}, {x, 0, 0}}, 0});
  }
  const BinaryTree tree = pt::build_binary_tree(std::move(boxes), 16);
  const pt::ChildChoice<16> choice(tree);
  const auto children = choice.of(0);
  for (int i = 0; i < children.count; ++i) {
    const pt::BinaryNode& child = tree.nodes[children.node[i]];
    EXPECT_FALSE(choice.is_block(children.node[i]) && child.box.volume() > 4);
  }
}

// If all boxes are points, a node costs nothing, and every choice of nodes the same. The tree must be as flat as
// possible, not a chain of nodes with two children each.
TEST(ChildChoice, NodesAreFullWhereAllChoicesAreAlike) {
  const BinaryTree tree =
      pt::build_binary_tree(std::vector<pt::BoxedPrimitive>(64, {{{0, 0, 0}, {0, 0, 0}}, 0}), 1);
  EXPECT_EQ(pt::ChildChoice<kWidth>(tree).of(0).count, kWidth);
}

}  // namespace
