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
  return pt::build_binary_tree(std::move(boxes), 1);
}

float least_area(const BinaryTree& tree, std::uint32_t node);

// The smallest area below any set of children that results from opening inner nodes of this node.
float least_of_sets(const BinaryTree& tree, const std::vector<std::uint32_t>& children) {
  float area = 0;
  for (const std::uint32_t child : children) area += least_area(tree, child);
  if (children.size() == kWidth) return area;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const pt::BinaryNode& child = tree.nodes[children[i]];
    if (child.count > 0) continue;
    std::vector<std::uint32_t> opened = children;
    opened[i] = child.first;
    opened.push_back(child.first + 1);
    area = std::min(area, least_of_sets(tree, opened));
  }
  return area;
}

// The smallest area of the wide nodes at and below a binary node.
float least_area(const BinaryTree& tree, std::uint32_t node) {
  const pt::BinaryNode& n = tree.nodes[node];
  if (n.count > 0) return 0;
  return n.box.half_area() + least_of_sets(tree, {n.first, n.first + 1});
}

// The half area of all chosen nodes below `node`; counts how often each leaf is reached.
float chosen_area(const BinaryTree& tree, const pt::ChildChoice<kWidth>& choice, std::uint32_t node,
                  std::vector<int>& reached) {
  if (tree.nodes[node].count > 0) {
    ++reached[tree.nodes[node].first];
    return 0;
  }
  const auto children = choice.of(node);
  EXPECT_GE(children.count, 2);
  EXPECT_LE(children.count, kWidth);
  float area = tree.nodes[node].box.half_area();
  for (int i = 0; i < children.count; ++i) {
    area += chosen_area(tree, choice, children.node[i], reached);
  }
  return area;
}

TEST(ChildChoice, NoOtherChoiceHasLessArea) {
  pt::Sampler sampler(4);
  for (int i = 0; i < 300; ++i) {
    const int leaves = 2 + i % 9;
    const BinaryTree tree = random_tree(leaves, sampler);
    std::vector<int> reached(static_cast<std::size_t>(leaves));
    const float area = chosen_area(tree, pt::ChildChoice<kWidth>(tree), 0, reached);
    EXPECT_NEAR(area, least_area(tree, 0), 1e-5f) << leaves << " leaves, tree " << i;
    EXPECT_EQ(reached, std::vector<int>(static_cast<std::size_t>(leaves), 1));
  }
}

// If all boxes are points, every choice has the same area. The tree must be as flat as possible,
// not a chain of nodes with two children each.
TEST(ChildChoice, NodesAreFullWhereAllChoicesAreAlike) {
  const BinaryTree tree =
      pt::build_binary_tree(std::vector<pt::BoxedPrimitive>(64, {{{0, 0, 0}, {0, 0, 0}}, 0}), 1);
  EXPECT_EQ(pt::ChildChoice<kWidth>(tree).of(0).count, kWidth);
}

}  // namespace
