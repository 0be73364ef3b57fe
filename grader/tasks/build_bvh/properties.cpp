#include "grader/check/language/property.h"
#include "grader/tasks/build_bvh/below.h"
#include "grader/tasks/build_bvh/inputs.h"
#include "grader/tasks/build_bvh/walk.h"
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace build_bvh_inputs;

// A tree with far more nodes or entries than necessary would only cost time.
pt::Bvh build(const Input& input) {
  pt::Bvh bvh = pt::build_bvh(input.boxes, input.max_leaf);
  const std::size_t n = input.boxes.size(), most = 4 * n + 16;
  expect(bvh.nodes.size() <= most && bvh.order.size() <= most,
         "at most " + std::to_string(2 * n - 1) + " nodes and " + std::to_string(n) +
             " entries in order for " + std::to_string(n) + " boxes",
         std::to_string(bvh.nodes.size()) + " nodes and " + std::to_string(bvh.order.size()) +
             " entries");
  return bvh;
}

// Every node's box must contain all boxes below it, and hardly more.
void expect_covered(const Input& input, const pt::Bvh& bvh) {
  const Below below = below_each_node(input, bvh);
  const double allowed = allowed_excess(input);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const pt::Box &box = bvh.nodes[i].box, &needed = below.boxes[i];
    if (needed.is_empty()) continue;
    const std::string has = node_name(static_cast<int>(i)) + " has the ";
    expect(contains(box, needed), "a box that contains everything below it, " + show(needed),
           has + (box.is_empty() ? "empty box" : show(box)));
    // A box that seems too large may belong to a primitive that is lost.
    const double more = excess(box, needed);
    if (!below.all || more <= allowed) continue;
    expect(false,
           "a box no larger than everything below it, except for rounding errors, " + show(needed),
           has + show(box) + ", larger by " + show(more));
  }
}

void expect_every_primitive_once(const Input& input, const pt::Bvh& bvh) {
  const auto n = static_cast<int>(input.boxes.size());
  expect_equal("entries in order", static_cast<long long>(bvh.order.size()), n);
  std::vector<int> seen(n), covered(n);
  for (const int primitive : bvh.order) {
    expect(primitive >= 0 && primitive < n, "indices of boxes in order, 0 to " + name_of(n - 1),
           name_of(primitive));
    ++seen[primitive];
  }
  for (const int i : walk_from_root(bvh)) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (!node.is_leaf()) continue;
    expect(
        node.first >= 0 && node.first <= n - node.count,
        "leaves that hold a part of order, which has " + name_of(n) + " entries",
        node_name(i) + " begins at " + name_of(node.first) + " and holds " + name_of(node.count));
    for (int k = node.first; k < node.first + node.count; ++k) ++covered[k];
  }
  for (int i = 0; i < n; ++i) {
    expect_equal("how often box " + name_of(i) + " is in order", seen[i], 1);
    expect_equal("how many leaves hold order[" + name_of(i) + "]", covered[i], 1);
  }
}

void expect_one_tree(const Input&, const pt::Bvh& bvh) {
  const auto count = static_cast<int>(bvh.nodes.size());
  std::vector<int> parents(bvh.nodes.size());
  for (int i = 0; i < count; ++i) {
    if (!has_children(bvh.nodes[i])) continue;
    for (const int child : {bvh.nodes[i].left, bvh.nodes[i].right}) {
      expect_child(bvh, i, child);
      expect(child > i, "children after their parent in the list",
             node_name(child) + " is a child of " + node_name(i));
      ++parents[child];
    }
  }
  expect_equal("parents of the root", parents[0], 0);
  for (int i = 1; i < count; ++i) expect_equal("parents of " + node_name(i), parents[i], 1);
}

void expect_small_leaves(const Input& input, const pt::Bvh& bvh) {
  const std::vector<int> walk = walk_from_root(bvh);
  const auto large =
      std::ranges::find_if(walk, [&](int i) { return bvh.nodes[i].count > input.max_leaf; });
  if (large == walk.end()) return;
  expect(false, "at most " + name_of(input.max_leaf) + " primitives in every leaf",
         name_of(bvh.nodes[*large].count) + " in " + node_name(*large) + ", " +
             name_of(depths(bvh)[*large]) + " levels below the root");
}

void expect_split(const Input& input, const pt::Bvh& bvh) {
  std::vector<long long> below(bvh.nodes.size());
  std::vector<int> walk = walk_from_root(bvh);
  std::ranges::reverse(walk);
  for (const int i : walk) {
    const pt::BvhNode& node = bvh.nodes[i];
    below[i] = has_children(node) ? below[node.left] + below[node.right] : node.count;
    expect(below[i] > 0, "something below every node", "nothing below " + node_name(i));
  }
  expect(bvh.nodes[0].is_leaf() <= (static_cast<int>(input.boxes.size()) <= input.max_leaf),
         "a root with two children", "a root that is a leaf of all boxes");
}

using Check = void (*)(const Input&, const pt::Bvh&);

// Fails unless all boxes are divided into leaves that are small enough. The other invariants do not
// depend on boxes that coincide or on axes that are equally long; other promises judge them.
void expect_divided(const Input& input, const pt::Bvh& bvh) {
  expect_every_primitive_once(input, bvh);
  expect_small_leaves(input, bvh);
  expect_split(input, bvh);
}

// Checks one invariant on every kind of boxes that a plane divides, up to the first kind that
// fails. Other promises judge the other kinds.
void check_usual_boxes(Check check) {
  once(expect_a_tree_at_all);
  for (const auto& [boxes, cases] : {std::pair{some_boxes(), 150}, std::pair{deep_boxes(), 20},
                                     std::pair{thousands_of_boxes(), 4}}) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [check, boxes = boxes] {
          const Input input = *boxes;
          const pt::Bvh bvh = build(input);
          expect_nodes(bvh);
          check(input, bvh);
        },
        cases);
  }
}

void check_boxes_of(const std::vector<Kind>& kinds, int most) {
  once(expect_a_tree_at_all);
  if (testing::Test::HasFailure()) return;
  for_all(
      [&] {
        const Input input = *boxes_of(kinds, 2, most);
        const pt::Bvh bvh = build(input);
        expect_nodes(bvh);
        expect_divided(input, bvh);
      },
      150);
}

// More boxes than 16 bits can count, and more nodes, since no leaf may hold more than two. The
// boxes are in a line, so that every method has little to do.
void check_more_than_16_bits_count() {
  if (testing::Test::HasFailure()) return;
  for_all(
      [] {
        const Input input = *rc::gen::exec([] { return in_a_line(66000, 2); });
        const pt::Bvh bvh = build(input);
        expect_nodes(bvh);
        expect_every_primitive_once(input, bvh);
      },
      1);
}

PROMISE(build_bvh, keeps_every_primitive_once) {
  check_usual_boxes(expect_every_primitive_once);
  check_more_than_16_bits_count();
}
PROMISE(build_bvh, covers_its_primitives) { check_usual_boxes(expect_covered); }
PROMISE(build_bvh, is_one_tree) { check_usual_boxes(expect_one_tree); }
PROMISE(build_bvh, keeps_leaves_small) {
  check_usual_boxes(expect_small_leaves);
  if (testing::Test::HasFailure()) return;
  for_all(
      [] {
        const Input input = *a_thousand_halvings();
        const pt::Bvh bvh = build(input);
        expect_nodes(bvh);
        expect_small_leaves(input, bvh);
      },
      1);
}
PROMISE(build_bvh, splits_until_it_must) { check_usual_boxes(expect_split); }
PROMISE(build_bvh, ends_on_identical_centroids) { check_boxes_of(kCoinciding, 300); }
PROMISE(build_bvh, ends_where_axes_are_equally_long) { check_boxes_of(kTied, 300); }

PROMISE(build_bvh, takes_no_boxes_and_one) {
  once(expect_a_tree_at_all);
  once([] {
    const pt::Bvh none = pt::build_bvh({}, 4);
    expect_equal("nodes without boxes", static_cast<long long>(none.nodes.size()), 0);
    expect_equal("entries in order without boxes", static_cast<long long>(none.order.size()), 0);
  });
  for_all([] {
    const Input one = *boxes_of({Kind::scattered, Kind::points, Kind::flat}, 1, 1);
    const pt::Bvh bvh = build(one);
    expect_equal("nodes for one box", static_cast<long long>(bvh.nodes.size()), 1);
    expect_every_primitive_once(one, bvh);
  });
}

// Returns how many boxes of the tree a ray enters if it crosses the plane of the rows. It is the
// mean over many rays through centres of boxes, the same rays for every tree.
double boxes_entered(const InRows& made, const pt::Bvh& bvh) {
  constexpr int kPoints = 200;
  const auto& [rows, input] = made;
  RandomNumbers make(1);
  long long entered = 0;
  for (int i = 0; i < kPoints; ++i) {
    const pt::Box& box = input.boxes[make.whole(0, static_cast<int>(input.boxes.size()) - 1)];
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
  once(expect_a_tree_at_all);
  // If every split halves a row, a ray enters one box per level. If the splits ignore where the
  // boxes are, it enters about half of all boxes.
  for (const auto& [count, each] : {std::pair{1, 1024}, std::pair{8, 128}}) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [count = count, each = each] {
          const InRows made =
              *rc::gen::mapcat(whole(0, 2), [=](int along) { return in_rows(along, count, each); });
          const double limit = 5 * std::log2(2 * count * each);
          const double entered = boxes_entered(made, build(made.input));
          expect(entered >= 1, "a root whose box holds the middles of all boxes",
                 "a ray across the row enters " + show(entered) +
                     " boxes of the tree on average: most rays miss even the root");
          expect(entered <= limit, "at most " + show(std::round(limit)),
                 "a ray across the row enters " + show(entered) + " of " +
                     std::to_string(2 * count * each) + " boxes of the tree on average");
        },
        30);
  }
}

PROMISE(build_bvh, stays_shallow_on_clustered_centroids_bonus) {
  once(expect_a_tree_at_all);
  for_all([] {
    const int axis = draw("axis", whole(0, 2)), n = draw("boxes", whole(100, 300));
    const pt::Bvh bvh = build(halving_points(axis, n));
    expect_nodes(bvh);
    const int most = static_cast<int>(4 * std::log2(n));
    expect(depth(bvh) <= most, "a depth of at most " + std::to_string(most),
           std::to_string(depth(bvh)));
  });
}

}  // namespace
}  // namespace grader::check
