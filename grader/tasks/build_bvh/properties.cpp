#include "grader/property/property.h"
#include "grader/tasks/build_bvh/cases.h"
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cmath>

namespace grader {
namespace {

using namespace build_bvh_cases;

std::string node_name(std::size_t index) { return "node " + std::to_string(index); }

// The tree, if all its indices point somewhere: what follows walks it. Children are larger than
// their parents, so that a loop over the nodes needs no recursion and always ends.
pt::Bvh build(const Input& input) {
  pt::Bvh bvh = pt::build_bvh(input.boxes, input.max_leaf);
  const auto nodes = static_cast<int>(bvh.nodes.size()), n = static_cast<int>(bvh.order.size());
  for (int i = 0; i < nodes; ++i) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (node.is_leaf()) {
      expect(node.first >= 0 && node.first <= n - node.count, "a range of order in every leaf",
             node_name(i) + " has the range from " + std::to_string(node.first) + ", " +
                 std::to_string(node.count) + " long, of " + std::to_string(n));
      continue;
    }
    for (const int child : {node.left, node.right}) {
      expect(child > i && child < nodes, "children with larger indices than their node",
             node_name(i) + ", which is no leaf, has the child " + std::to_string(child));
    }
  }
  return bvh;
}

// For each node, how many primitives are below it.
std::vector<long long> sizes(const pt::Bvh& bvh) {
  std::vector<long long> below(bvh.nodes.size());
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    const pt::BvhNode& node = bvh.nodes[i];
    below[i] = node.is_leaf() ? node.count : below[node.left] + below[node.right];
  }
  return below;
}

void expect_every_primitive_once(const Input& input, const pt::Bvh& bvh) {
  const std::size_t n = input.boxes.size();
  expect_equal("entries in order", static_cast<long long>(bvh.order.size()),
               static_cast<long long>(n));
  std::vector<int> seen(n), covered(n);
  for (const int primitive : bvh.order) {
    expect(primitive >= 0 && primitive < static_cast<int>(n), "indices of boxes in order",
           std::to_string(primitive));
    ++seen[primitive];
  }
  for (const pt::BvhNode& node : bvh.nodes) {
    if (!node.is_leaf()) continue;
    for (int i = node.first; i < node.first + node.count; ++i) ++covered[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    expect_equal("how often box " + std::to_string(i) + " is in order", seen[i], 1);
    expect_equal("how many leaves hold position " + std::to_string(i) + " of order", covered[i], 1);
  }
}

PROMISE(build_bvh, keeps_every_primitive_once) {
  for_all([] {
    const Input input = *some_boxes();
    expect_every_primitive_once(input, build(input));
  });
}

bool contains(const pt::Box& outer, const pt::Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(outer.min[axis] <= inner.min[axis] && outer.max[axis] >= inner.max[axis])) return false;
  }
  return true;
}

PROMISE(build_bvh, covers_its_primitives) {
  for_all([] {
    const Input input = *some_boxes();
    const pt::Bvh bvh = build(input);
    expect(!bvh.nodes.empty(), "a tree", "no nodes");
    std::vector<pt::Box> needed(bvh.nodes.size());
    for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
      const pt::BvhNode& node = bvh.nodes[i];
      for (int k = node.first; node.is_leaf() && k < node.first + node.count; ++k) {
        const int primitive = bvh.order[k];
        expect(primitive >= 0 && primitive < static_cast<int>(input.boxes.size()),
               "indices of boxes in order", std::to_string(primitive));
        needed[i].grow(input.boxes[primitive]);
      }
      if (!node.is_leaf()) {
        needed[i].grow(needed[node.left]);
        needed[i].grow(needed[node.right]);
      }
      expect(contains(node.box, needed[i]), "a box that holds " + show(needed[i]),
             node_name(i) + ": " + show(node.box));
    }
  });
}

PROMISE(build_bvh, is_one_tree) {
  for_all([] {
    const Input input = *some_boxes();
    const pt::Bvh bvh = build(input);
    expect(!bvh.nodes.empty(), "a tree", "no nodes");
    std::vector<int> parents(bvh.nodes.size());
    for (const pt::BvhNode& node : bvh.nodes) {
      if (!node.is_leaf()) ++parents[node.left], ++parents[node.right];
    }
    expect_equal("parents of the root", parents[0], 0);
    for (std::size_t i = 1; i < parents.size(); ++i) {
      expect_equal("parents of " + node_name(i), parents[i], 1);
    }
  });
}

void expect_small_leaves(const Input& input, const pt::Bvh& bvh) {
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    expect(bvh.nodes[i].count <= input.max_leaf,
           "at most " + std::to_string(input.max_leaf) + " primitives in a leaf",
           std::to_string(bvh.nodes[i].count) + " in " + node_name(i));
  }
}

PROMISE(build_bvh, keeps_leaves_small) {
  for_all([] {
    const Input input = *some_boxes();
    expect_small_leaves(input, build(input));
  });
}

PROMISE(build_bvh, splits_until_it_must) {
  for_all([] {
    const Input input = *some_boxes();
    const pt::Bvh bvh = build(input);
    expect(!bvh.nodes.empty(), "a tree", "no nodes");
    const std::vector<long long> below = sizes(bvh);
    for (std::size_t i = 0; i < below.size(); ++i) {
      expect(below[i] > 0, "something below every node", "nothing below " + node_name(i));
    }
    expect(bvh.nodes[0].is_leaf() <= (static_cast<int>(input.boxes.size()) <= input.max_leaf),
           "a root with children", "a root that is a leaf");
  });
}

PROMISE(build_bvh, takes_no_boxes_and_one) {
  once([] {
    const pt::Bvh none = pt::build_bvh({}, 4);
    expect_equal("nodes without boxes", static_cast<long long>(none.nodes.size()), 0);
    expect_equal("entries in order without boxes", static_cast<long long>(none.order.size()), 0);
  });
  for_all([] {
    const Input one = *boxes_of(kAll, 1, 1);
    const pt::Bvh bvh = build(one);
    expect_equal("nodes for one box", static_cast<long long>(bvh.nodes.size()), 1);
    expect_every_primitive_once(one, bvh);
  });
}

PROMISE(build_bvh, ends_on_identical_centroids) {
  for_all([] {
    const Input input = *boxes_of({Kind::identical, Kind::same_center}, 2, 300);
    const pt::Bvh bvh = build(input);
    expect_every_primitive_once(input, bvh);
    expect_small_leaves(input, bvh);
  });
}

// How many boxes of the tree hold a point of the rows, in the two axes of their plane: those that a
// ray across it has to look into. The mean over many points, all the same for every tree.
double boxes_entered(const Rows& rows, const pt::Bvh& bvh) {
  constexpr int kPoints = 200;
  Many make(1);
  long long entered = 0;
  for (int i = 0; i < kPoints; ++i) {
    const pt::Box& box =
        rows.input.boxes[make.whole(0, static_cast<int>(rows.input.boxes.size()) - 1)];
    for (const pt::BvhNode& node : bvh.nodes) {
      bool inside = true;
      for (const int axis : {rows.along, rows.across}) {
        const double at = box.center()[axis];
        inside = inside && at >= node.box.min[axis] && at <= node.box.max[axis];
      }
      entered += inside;
    }
  }
  return static_cast<double>(entered) / kPoints;
}

PROMISE(build_bvh, separates_along_the_longest_axis) {
  // A split that halves a row enters one box a level; one that ignores where the boxes are enters
  // about every other of all.
  for (const auto& [count, each] : {std::pair{1, 1024}, std::pair{8, 128}}) {
    for (const int along : {0, 1, 2}) {
      for_all(
          [along, count = count, each = each] {
            const Rows rows = *in_rows(along, count, each);
            const double limit = 5 * std::log2(2 * count * each);
            const double entered = boxes_entered(rows, build(rows.input));
            expect(entered > 0 && entered <= limit,
                   "at most " + grader::show(limit) + " boxes entered, in the mean",
                   grader::show(entered));
          },
          10);
    }
  }
}

int depth(const pt::Bvh& bvh) {
  std::vector<int> below(bvh.nodes.size());
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (!node.is_leaf()) below[i] = 1 + std::max(below[node.left], below[node.right]);
  }
  return below.empty() ? 0 : below[0];
}

PROMISE(build_bvh, stays_shallow_on_clustered_centroids_bonus) {
  for_all([] {
    const int axis = draw("axis", whole(0, 2)), n = draw("boxes", whole(100, 300));
    Input input{{}, 1};
    for (int i = 0; i < n; ++i) {
      pt::Vec3 p;
      p[axis] = std::pow(2, -i);
      input.boxes.push_back(around(p, {0, 0, 0}));
    }
    const pt::Bvh bvh = build(input);
    expect(!bvh.nodes.empty(), "a tree", "no nodes");
    const int most = static_cast<int>(4 * std::log2(n));
    expect(depth(bvh) <= most, "a depth of at most " + std::to_string(most),
           std::to_string(depth(bvh)));
  });
}

}  // namespace
}  // namespace grader
