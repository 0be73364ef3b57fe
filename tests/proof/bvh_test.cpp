#include "pt/tasks/build_bvh.h"
#include "tests/proof/meshes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// The promises of pt/geometry/bvh.h and pt/tasks/build_bvh.h for every tree.

namespace pt::proof {
namespace {

bool contains(const Box& outer, const Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(outer.min[axis] <= inner.min[axis] && inner.max[axis] <= outer.max[axis])) return false;
  }
  return true;
}

bool same(const Box& a, const Box& b) { return a.min == b.min && a.max == b.max; }

// Children come after their parents, so one pass fills the depths and the parents.
int depth(const Bvh& bvh) {
  std::vector<int> depths(bvh.nodes.size(), 1);
  int deepest = 0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    deepest = std::max(deepest, depths[i]);
    if (!node.is_leaf()) depths[node.left] = depths[node.right] = depths[i] + 1;
  }
  return deepest;
}

void expect_leaf(const Bvh& bvh, const std::vector<Box>& boxes, const BvhNode& node, int max_leaf,
                 std::vector<int>& covered) {
  EXPECT_LE(node.count, max_leaf);
  EXPECT_EQ(node.left, -1);
  EXPECT_EQ(node.right, -1);
  ASSERT_GE(node.first, 0);
  ASSERT_LE(node.first + node.count, static_cast<int>(boxes.size()));
  Box box;
  for (int i = node.first; i < node.first + node.count; ++i) {
    ++covered[i];
    box.grow(boxes[bvh.order[i]]);
  }
  EXPECT_TRUE(contains(node.box, box));
  EXPECT_TRUE(same(node.box, box)) << "larger than it needs to be";
}

void expect_tree(const Bvh& bvh, const std::vector<Box>& boxes, int max_leaf) {
  const int n = static_cast<int>(boxes.size());
  std::vector<int> order = bvh.order;
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), boxes.size());
  for (int i = 0; i < n; ++i) ASSERT_EQ(order[i], i);
  if (n == 0) {
    EXPECT_TRUE(bvh.nodes.empty());
    return;
  }
  std::vector<int> covered(boxes.size()), parents(bvh.nodes.size());
  int leaves = 0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    if (node.is_leaf()) {
      ++leaves;
      expect_leaf(bvh, boxes, node, max_leaf, covered);
      continue;
    }
    for (const int child : {node.left, node.right}) {
      ASSERT_GT(child, static_cast<int>(i));
      ASSERT_LT(child, static_cast<int>(bvh.nodes.size()));
      ++parents[child];
      EXPECT_TRUE(contains(node.box, bvh.nodes[child].box));
    }
  }
  EXPECT_EQ(parents[0], 0);
  for (std::size_t i = 1; i < parents.size(); ++i) EXPECT_EQ(parents[i], 1);
  for (const int times : covered) EXPECT_EQ(times, 1);
  // A tree in which every inner node has two children has one leaf more than inner nodes.
  EXPECT_EQ(static_cast<int>(bvh.nodes.size()), 2 * leaves - 1);
  EXPECT_GE(leaves, (n + max_leaf - 1) / max_leaf);
  EXPECT_EQ(leaves == 1, n <= max_leaf);
}

std::vector<Box> boxes_of(const Primitives& primitives) {
  std::vector<Box> boxes;
  boxes.reserve(static_cast<std::size_t>(primitives.size()));
  for (int i = 0; i < primitives.size(); ++i) boxes.push_back(bounds(primitives, i));
  return boxes;
}

TEST(BuildBvh, keeps_its_invariants_on_every_mesh) {
  for (const Mesh& mesh : meshes()) {
    const std::vector<Box> boxes = boxes_of(mesh.primitives);
    for (int max_leaf = 1; max_leaf <= 8; ++max_leaf) {
      SCOPED_TRACE(mesh.name + ", leaves of " + std::to_string(max_leaf));
      expect_tree(build_bvh(boxes, max_leaf), boxes, max_leaf);
    }
    expect_tree(build_bvh(boxes, mesh.primitives.size()), boxes, mesh.primitives.size());
  }
}

TEST(BuildBvh, takes_none_and_few) {
  Sampler sampler(71);
  std::vector<Box> boxes;
  for (int n = 0; n <= 20; ++n) {
    for (int max_leaf = 1; max_leaf <= 8; ++max_leaf) {
      expect_tree(build_bvh(boxes, max_leaf), boxes, max_leaf);
    }
    const Vec3 corner = in_cube(sampler);
    boxes.push_back({corner, corner + Vec3{0, 1, n % 3 == 0 ? 0.0 : 0.5}});
  }
}

TEST(BuildBvh, ends_on_identical_boxes) {
  for (const int n : {2, 9, 1000, 100000}) {
    const std::vector<Box> boxes(n, Box{{1, 2, 3}, {1, 4, 3}});
    const Bvh bvh = build_bvh(boxes, 1);
    expect_tree(bvh, boxes, 1);
    EXPECT_LE(depth(bvh), 2 + std::ceil(std::log2(n)));
  }
}

Box at(double x, int axis) {
  Vec3 p{0, 0, 0};
  p[axis] = x;
  return {p, p};
}

// The largest and the smallest numbers that exist, neighbours without a number between them, and
// centres whose sum overflows: boxes have to be divided even if no plane divides them.
TEST(BuildBvh, ends_at_the_ends_of_the_numbers) {
  const double huge = 1.7e308, tiny = 5e-324;
  const double next = std::nextafter(1.0, 2.0);
  for (int axis = 0; axis < 3; ++axis) {
    for (const auto& [a, b] : {std::pair{huge, -huge},
                               {huge, 0.9 * huge},
                               {tiny, 0.0},
                               {tiny, -tiny},
                               {1.0, next},
                               {0.0, -0.0}}) {
      std::vector<Box> boxes;
      boxes.reserve(7);
      for (int i = 0; i < 7; ++i) boxes.push_back(at(i % 3 == 0 ? a : b, axis));
      expect_tree(build_bvh(boxes, 1), boxes, 1);
    }
  }
}

// Each midpoint would separate only the box at 2^-i, so an unlimited tree would be as deep as the
// number of boxes. Planes that follow the scene get twice the depth of an even tree, then halves.
TEST(BuildBvh, stays_shallow_on_clustered_centroids) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int n : {10, 200, 1000}) {
      for (const double base : {0.5, 0.9, 2.0}) {
        std::vector<Box> boxes;
        boxes.reserve(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) boxes.push_back(at(std::pow(base, i), axis));
        const Bvh bvh = build_bvh(boxes, 1);
        expect_tree(bvh, boxes, 1);
        EXPECT_LE(depth(bvh), 1 + 3 * std::ceil(std::log2(n))) << n << " at " << base << "^i";
      }
    }
  }
}

// Boxes in a row along one axis, in random order, at any scale. Halves of halves make the tree as
// shallow as possible, and no two siblings overlap.
TEST(BuildBvh, separates_along_the_longest_axis) {
  Sampler sampler(72);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
      std::vector<Box> boxes;
      for (int i = 0; i < 256; ++i) {
        Vec3 low = scale * in_cube(sampler, 0.2);
        low[axis] = scale * ((i * 101) % 256);
        boxes.push_back({low, low + scale * Vec3{0.5, 0.5, 0.5}});
      }
      const Bvh bvh = build_bvh(boxes, 1);
      expect_tree(bvh, boxes, 1);
      EXPECT_EQ(depth(bvh), 9);
      for (const BvhNode& node : bvh.nodes) {
        if (node.is_leaf()) continue;
        const Box &left = bvh.nodes[node.left].box, &right = bvh.nodes[node.right].box;
        EXPECT_TRUE(left.max[axis] < right.min[axis] || right.max[axis] < left.min[axis]);
      }
    }
  }
}

// Nodes in an order that the reference does not use.
TEST(BvhBuilder, makes_a_tree_of_leaves_in_any_order) {
  std::vector<Box> boxes;
  for (int i = 0; i < 5; ++i) boxes.push_back(at(i, 1));
  BvhBuilder tree(boxes);
  const int c = tree.leaf(std::vector{4}), a = tree.leaf(std::vector{2, 0});
  const int b = tree.leaf(std::vector{1, 3});
  const int upper = tree.inner(b, c);
  const Bvh bvh = tree.finish(tree.inner(a, upper));
  expect_tree(bvh, boxes, 2);
  EXPECT_EQ(bvh.order, (std::vector{4, 2, 0, 1, 3}));
  EXPECT_EQ(bvh.nodes[bvh.nodes[0].left].box.max.y, 2);
}

TEST(BvhBuilder, refuses_nodes_that_are_not_there) {
  const std::vector<Box> boxes{at(0, 0), at(1, 0)};
  BvhBuilder tree(boxes);
  EXPECT_THROW(tree.leaf({}), std::logic_error);
  EXPECT_THROW(tree.finish(0), std::logic_error);
  const int leaf = tree.leaf(std::vector{0, 1});
  EXPECT_THROW(tree.inner(leaf, -1), std::logic_error);
  const int other = tree.leaf(std::vector{0});
  EXPECT_THROW(tree.inner(other, other), std::logic_error) << "it would have two parents";
}

}  // namespace
}  // namespace pt::proof
