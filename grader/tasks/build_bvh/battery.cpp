#include "grader/mistakes/battery.h"

#include "grader/check/generators/random_numbers.h"
#include "grader/tasks/build_bvh/inputs.h"
#include "grader/tasks/build_bvh/walk.h"
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cmath>

// The contract does not say how to split boxes. So an answer contains which invariants a tree
// breaks and how well it separates boxes, and nothing else about its shape.

namespace grader::mistakes {
namespace {

using namespace check;

using namespace build_bvh_inputs;

using pt::Bvh;
using pt::BvhNode;
using pt::Vec3;

// Counts of the faults of a tree.
struct Faults {
  double order_length = 0;  // the length of `order` minus the number of boxes
  double lost = 0, doubled = 0, strangers = 0;
  double not_covered = 0, not_in_parent = 0;
  double bad_children = 0, orphans = 0, shared = 0;
  double too_large = 0, largest = 0;
  double empty = 0, oversized_by_far = 0;
};

void look_at_leaf(const Bvh& bvh, const Boxes& boxes, const BvhNode& node, int max_leaf,
                  std::vector<int>& held, Faults& faults) {
  if (node.count > max_leaf) ++faults.too_large;
  faults.largest = std::max(faults.largest, static_cast<double>(node.count));
  for (int i = node.first; i < node.first + node.count; ++i) {
    const int primitive = primitive_at(bvh, i, boxes.size());
    if (primitive < 0) {
      ++faults.strangers;
      continue;
    }
    ++held[primitive];
    if (!contains(node.box, boxes[primitive])) ++faults.not_covered;
  }
}

Faults faults_of(const Bvh& bvh, const Boxes& boxes, int max_leaf) {
  Faults faults;
  const int nodes = static_cast<int>(bvh.nodes.size());
  std::vector<int> held(boxes.size()), parents(nodes);
  faults.order_length = static_cast<double>(bvh.order.size()) - static_cast<double>(boxes.size());
  for (int i = 0; i < nodes; ++i) {
    const BvhNode& node = bvh.nodes[i];
    if (node.is_leaf()) {
      look_at_leaf(bvh, boxes, node, max_leaf, held, faults);
      continue;
    }
    if (node.left < 0 && node.right < 0) ++faults.empty;
    for (const int child : {node.left, node.right}) {
      if (child <= i || child >= nodes) ++faults.bad_children;
      if (child < 0 || child >= nodes) continue;
      ++parents[child];
      if (!contains(node.box, bvh.nodes[child].box)) ++faults.not_in_parent;
    }
  }
  for (const int times : held) {
    faults.lost += times == 0 ? 1 : 0;
    faults.doubled += times > 1 ? 1 : 0;
  }
  for (int i = 0; i < nodes; ++i) {
    faults.orphans += i > 0 && parents[i] == 0 ? 1 : 0;
    faults.shared += parents[i] > 1 ? 1 : 0;
  }
  return faults;
}

// Returns how many boxes of the tree a line along `axis` meets, in the mean over lines through the
// centres of boxes. It is some logarithm if the boxes are well separated, and all boxes at worst.
double entered(const Bvh& bvh, const Boxes& boxes, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double sum = 0;
  for (std::size_t i = 0; i < boxes.size(); i += 5) {
    const Vec3 p = boxes[i].center();
    for (const BvhNode& node : bvh.nodes) {
      const bool inside = node.box.min[u] <= p[u] && p[u] <= node.box.max[u] &&
                          node.box.min[v] <= p[v] && p[v] <= node.box.max[v];
      sum += inside ? 1 : 0;
    }
  }
  return sum / std::ceil(static_cast<double>(boxes.size()) / 5);
}

void ask(Battery& battery, const Boxes& boxes, int max_leaf, int across = -1) {
  battery.ask([&]() -> Battery::Numbers {
    const Bvh bvh = built(boxes, max_leaf);
    const Faults f = faults_of(bvh, boxes, max_leaf);
    const double n = static_cast<double>(boxes.size());
    // Right trees have at most 0.38 of n / max_leaf, in rows of rows. Bad trees have more, up to 2.
    const double well = across < 0 ? 0 : entered(bvh, boxes, across);
    return {f.order_length,
            f.lost,
            flag(f.doubled > 0),
            flag(f.strangers > 0),
            flag(f.not_covered > 0),
            flag(f.not_in_parent > 0),
            flag(f.bad_children > 0),
            flag(f.orphans > 0),
            flag(f.shared > 0),
            flag(f.too_large > 0),
            flag(f.largest > max_leaf + 1),
            flag(f.largest > 2 * max_leaf + 2),
            flag(f.largest == n && n > max_leaf),
            flag(f.empty > 0),
            flag(n > max_leaf && bvh.nodes.size() == 1),
            flag(bvh.nodes.empty()),
            flag(n > 0 && well > 0.43 * n / max_leaf)};
  });
}

// One row along each axis, at several places and scales. It is more out of line on one of the two
// other axes.
void rows(Battery& battery, RandomNumbers& make) {
  for (const double scale : {1e-4, 1.0, 1e3}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double jitter : {1e-6, 1e-2}) {
        const Rows row{.along = axis, .length = 64 * scale, .jitter = jitter};
        ask(battery, boxes_in(row, make), 2, (axis + 1) % 3);
      }
    }
  }
  ask(battery, boxes_in({.length = 64e-8, .jitter = 1e-6}, make), 2, 1);
  // The row is far from the origin on another axis.
  for (int axis = 0; axis < 3; ++axis) {
    for (const int away : {1, 2}) {
      const Rows row{.along = axis, .corner = on_axis((axis + away) % 3, 500)};
      ask(battery, boxes_in(row, make), 1, (axis + 1) % 3);
    }
  }
}

// Rows of rows: the longest axis of all boxes is not the longest axis of one row.
void rows_of_rows(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int other : {1, 2}) {
      const int across = (axis + other) % 3;
      const Rows rows{.along = axis, .across = across, .count = 4, .each = 16, .length = 16};
      ask(battery, boxes_in(rows, make), 1, 3 - axis - across);
      ask(battery, boxes_in(rows, make), 1, across);
    }
  }
}

void sizes(Battery& battery, RandomNumbers& make) {
  for (const int max_leaf : {1, 2, 3, 4, 7, 8, 9}) {
    for (const int n : {max_leaf - 1, max_leaf, max_leaf + 1, 40}) {
      ask(battery, scattered(n, make), max_leaf);
    }
  }
  for (const int n : {1, 2, 3, 5, 64, 200}) ask(battery, scattered(n, make), 1);
}

void alike(Battery& battery, RandomNumbers& make) {
  for (const int max_leaf : {1, 4}) {
    for (const int n : {2, 5, 16, 40}) {
      ask(battery, boxes_of_kind(Kind::identical, n, 0, make), max_leaf);
    }
    ask(battery, boxes_of_kind(Kind::same_center, 20, 0, make), max_leaf);
    for (const bool in_turn : {false, true}) ask(battery, in_two_piles(in_turn), max_leaf);
    ask(battery, halving_points(0, 40).boxes, max_leaf);
  }
}

// Asks by how much boxes are larger than what is below them, as parts of the largest coordinate:
// more than rounding errors of double, more than those of single precision, and far more.
void too_wide(Battery& battery, RandomNumbers& make) {
  const Input input{scattered(40, make), 2};
  battery.ask([&]() -> Battery::Numbers {
    const Bvh bvh = built(input.boxes, input.max_leaf);
    const Below below = below_each_node(input, bvh);
    double most = 0;
    for (std::size_t i = 0; i < bvh.nodes.size() && below.all; ++i) {
      most = std::max(most, excess(bvh.nodes[i].box, below.boxes[i]));
    }
    const double allowed = allowed_excess(input);
    return {flag(most > allowed), flag(most > 3e5 * allowed), flag(most > 1e7 * allowed)};
  });
}

// Thousands of boxes, and points in a tree of hundreds of levels, with one box per leaf. Then a
// diagonal, on which all axes are equally long at every level.
void many(Battery& battery, RandomNumbers& make) {
  ask(battery, scattered(2500, make), 1);
  ask(battery, halving_points(0, 1000).boxes, 1);
  ask(battery, boxes_of_kind(Kind::diagonal, 16, 0, make), 1);
}

// More boxes and nodes than 16 bits can count. A method that makes no tree of a row is not asked
// this, because it could take minutes.
void large_numbers(Battery& battery) {
  battery.ask([]() -> Battery::Numbers {
    expect_a_tree_at_all();
    const Input row = in_a_line(66000, 2);
    const Faults f = faults_of(built(row.boxes, row.max_leaf), row.boxes, row.max_leaf);
    return {flag(f.lost > 0), flag(f.doubled > 0), flag(f.bad_children > 0), flag(f.orphans > 0)};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  RandomNumbers make(5);
  ask(battery, {}, 1);
  ask(battery, {}, 4);
  sizes(battery, make);
  rows(battery, make);
  rows_of_rows(battery, make);
  alike(battery, make);
  too_wide(battery, make);
  many(battery, make);
  large_numbers(battery);
  ask(battery, boxes_in({.flat = 1}, make), 1, 2);
}

}  // namespace grader::mistakes
