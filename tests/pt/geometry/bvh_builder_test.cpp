#include "pt/geometry/bvh_builder.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace pt {
namespace {

std::vector<Box> points_on_x(int n) {
  std::vector<Box> boxes;
  for (int i = 0; i < n; ++i) boxes.push_back({{1.0 * i, 0, 0}, {1.0 * i, 0, 0}});
  return boxes;
}

// In an order that the reference does not use. The promises of build_bvh test its trees.
TEST(BvhBuilder, makes_a_tree_of_leaves_in_any_order) {
  const std::vector<Box> boxes = points_on_x(5);
  BvhBuilder tree(boxes);
  const int c = tree.leaf(std::vector{4}), a = tree.leaf(std::vector{2, 0});
  const int b = tree.leaf(std::vector{1, 3});
  const int upper = tree.inner(b, c);
  const Bvh bvh = tree.finish(tree.inner(a, upper));

  EXPECT_EQ(bvh.order, (std::vector{4, 2, 0, 1, 3}));
  ASSERT_EQ(bvh.nodes.size(), 5u);
  const auto expect_node = [&](int i, int left, int right, int first, int count, double low,
                               double high) {
    const BvhNode& node = bvh.nodes[i];
    EXPECT_EQ((std::vector{node.left, node.right, node.first, node.count}),
              (std::vector{left, right, first, count}))
        << i;
    EXPECT_EQ(node.box.min.x, low) << i;
    EXPECT_EQ(node.box.max.x, high) << i;
  };
  expect_node(0, 1, 2, 0, 0, 0, 4);
  expect_node(1, -1, -1, 1, 2, 0, 2);
  expect_node(2, 3, 4, 0, 0, 1, 4);
  expect_node(3, -1, -1, 3, 2, 1, 3);
  expect_node(4, -1, -1, 0, 1, 4, 4);
}

TEST(BvhBuilder, refuses_what_is_not_there) {
  const std::vector<Box> boxes = points_on_x(2);
  BvhBuilder tree(boxes);
  EXPECT_THROW(tree.leaf({}), std::logic_error);
  EXPECT_THROW(tree.leaf(std::vector{0, 2}), std::logic_error);
  EXPECT_THROW(tree.leaf(std::vector{-1}), std::logic_error);
  EXPECT_THROW(tree.finish(0), std::logic_error);
  const int leaf = tree.leaf(std::vector{0, 1});
  EXPECT_THROW(tree.inner(leaf, -1), std::logic_error);
  const int other = tree.leaf(std::vector{0});
  EXPECT_THROW(tree.inner(other, other), std::logic_error) << "it would have two parents";
}

}  // namespace
}  // namespace pt
