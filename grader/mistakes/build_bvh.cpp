#include "pt/tasks/build_bvh.h"

#include "grader/check/random_numbers.h"
#include "grader/mistakes/battery.h"
#include "grader/tasks/build_bvh/below.h"
#include "grader/tasks/build_bvh/cases.h"
#include "grader/tasks/build_bvh/walk.h"

#include <algorithm>
#include <array>
#include <cmath>

// The contract does not say how to split boxes. So an answer contains which invariants a tree
// breaks and how well it separates boxes, and nothing else about its shape.

namespace grader::mistakes {
namespace {

using namespace check;

using namespace build_bvh_cases;

using pt::Box;
using pt::Bvh;
using pt::BvhNode;
using pt::Vec3;

using Boxes = std::vector<Box>;

// Counts of the faults of a tree.
struct Faults {
  double order_length = 0;  // the length of `order` minus the number of boxes
  double lost = 0, doubled = 0, strangers = 0;
  double not_covered = 0, not_in_parent = 0;
  double bad_children = 0, orphans = 0, shared = 0;
  double too_large = 0, largest = 0;
  double empty = 0, oversized_by_far = 0;
};

bool in_order(const Bvh& bvh, int i) { return i >= 0 && i < static_cast<int>(bvh.order.size()); }

void look_at_leaf(const Bvh& bvh, const Boxes& boxes, const BvhNode& node, int max_leaf,
                  std::vector<int>& held, Faults& faults) {
  if (node.count > max_leaf) ++faults.too_large;
  faults.largest = std::max(faults.largest, static_cast<double>(node.count));
  for (int i = node.first; i < node.first + std::min(node.count, 100000); ++i) {
    if (!in_order(bvh, i) || bvh.order[i] < 0 || bvh.order[i] >= static_cast<int>(boxes.size())) {
      ++faults.strangers;
      continue;
    }
    ++held[bvh.order[i]];
    if (!contains(node.box, boxes[bvh.order[i]])) ++faults.not_covered;
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
    const Bvh bvh = pt::build_bvh(boxes, max_leaf);
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

Boxes scattered(RandomNumbers& make, int n) {
  Boxes boxes;
  for (int i = 0; i < n; ++i) boxes.push_back(around(make.vector(-9, 9), make.vector(0.01, 1)));
  return boxes;
}

// A grid of boxes in random order. `step` is their distance on each axis.
Boxes grid(RandomNumbers& make, std::array<int, 3> count, Vec3 step, Vec3 corner, double half) {
  Boxes boxes;
  for (int i = 0; i < count[0]; ++i) {
    for (int j = 0; j < count[1]; ++j) {
      for (int k = 0; k < count[2]; ++k) {
        const Vec3 p = corner + Vec3{i * step.x, j * step.y, k * step.z};
        boxes.push_back(around(p + 1e-3 * half * make.vector(-1, 1), {half, half, half}));
      }
    }
  }
  make.shuffle(boxes);
  return boxes;
}

// Boxes in one row along an axis. They are a little out of line: on the axis that is
// `thinner` axes further by a thousandth of that on the third one.
Boxes row(RandomNumbers& make, double scale, int axis, int thinner) {
  Boxes boxes;
  for (int i = 0; i < 64; ++i) {
    Vec3 p = 0.2 * scale * make.vector(-1, 1);
    p[(axis + thinner) % 3] *= 1e-3;
    p[axis] = scale * i;
    boxes.push_back(around(p, 0.4 * Vec3{scale, scale, scale}));
  }
  make.shuffle(boxes);
  return boxes;
}

// One row along each axis, at several places and scales.
void rows(Battery& battery, RandomNumbers& make) {
  for (const double scale : {1e-4, 1.0, 1e3}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int thinner : {1, 2}) {
        ask(battery, row(make, scale, axis, thinner), 2, (axis + 1) % 3);
      }
    }
  }
  ask(battery, row(make, 1e-8, 0, 1), 2, 1);
  // The row is far from the origin on another axis.
  for (int axis = 0; axis < 3; ++axis) {
    for (const int away : {1, 2}) {
      std::array<int, 3> count{1, 1, 1};
      count[axis] = 64;
      Vec3 corner;
      corner[(axis + away) % 3] = 500;
      ask(battery, grid(make, count, {1, 1, 1}, corner, 0.3), 1, (axis + 1) % 3);
    }
  }
}

// Rows of rows: the longest axis of all boxes is not the longest axis of one row.
void rows_of_rows(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int other : {1, 2}) {
      const int across = (axis + other) % 3;
      std::array<int, 3> count{1, 1, 1};
      Vec3 step{1, 1, 1};
      count[axis] = 16;
      count[across] = 4;
      step[across] = 12;
      ask(battery, grid(make, count, step, {}, 0.4), 1, 3 - axis - across);
      ask(battery, grid(make, count, step, {}, 0.4), 1, across);
    }
  }
}

void sizes(Battery& battery, RandomNumbers& make) {
  for (const int max_leaf : {1, 2, 3, 4, 7, 8, 9}) {
    for (const int n : {max_leaf - 1, max_leaf, max_leaf + 1, 40}) {
      ask(battery, scattered(make, n), max_leaf);
    }
  }
  for (const int n : {1, 2, 3, 5, 64, 200}) ask(battery, scattered(make, n), 1);
}

void alike(Battery& battery, RandomNumbers& make) {
  for (const int max_leaf : {1, 4}) {
    for (const int n : {2, 5, 16, 40}) {
      ask(battery, Boxes(n, around({1, 2, 3}, {1, 1, 1})), max_leaf);
    }
    Boxes nested, points, pairs;
    for (int i = 0; i < 20; ++i) {
      nested.push_back(around({1, 1, 1}, make.vector(0.1, 2)));
      points.push_back(around({i < 10 ? 0.0 : 1.0, 0, 0}, {0, 0, 0}));
      pairs.push_back(around({1.0 * (i % 2), 3, 0}, {0.1, 0, 0.1}));
    }
    for (const Boxes& boxes : {nested, points, pairs}) ask(battery, boxes, max_leaf);
    Boxes clustered;
    for (int i = 0; i < 40; ++i) clustered.push_back(around({std::pow(2, -i), 0, 0}, {0, 0, 0}));
    ask(battery, clustered, max_leaf);
  }
}

// Asks by how much boxes are larger than what is below them, as parts of the largest coordinate: more than
// rounding errors of double, more than those of single precision, and far more.
void too_wide(Battery& battery, RandomNumbers& make) {
  const Input input{scattered(make, 40), 2, ""};
  battery.ask([&]() -> Battery::Numbers {
    const Bvh bvh = pt::build_bvh(input.boxes, input.max_leaf);
    const Below below = below_each_node(input, bvh);
    double most = 0;
    for (std::size_t i = 0; i < bvh.nodes.size() && below.all; ++i) {
      most = std::max(most, excess(bvh.nodes[i].box, below.boxes[i]));
    }
    const double allowed = allowed_excess(input);
    return {flag(most > allowed), flag(most > 300 * allowed), flag(most > 1e4 * allowed)};
  });
}

// Thousands of boxes, and points in a tree of hundreds of levels, for leaves of one. Then a diagonal, on
// which all axes are equally long at every level.
void many(Battery& battery, RandomNumbers& make) {
  ask(battery, scattered(make, 2500), 1);
  Boxes halving, diagonal;
  for (int i = 0; i < 1000; ++i) halving.push_back(around({std::pow(2, -i), 0, 0}, {0, 0, 0}));
  for (int i = 0; i < 16; ++i) diagonal.push_back(around(i * Vec3{1, 1, 1}, {0.25, 0.25, 0.25}));
  for (const Boxes& boxes : {halving, diagonal}) ask(battery, boxes, 1);
}

// More boxes and nodes than 16 bits can count. Of a method that makes no tree of a row, this is not
// asked: it could take minutes.
void large_numbers(Battery& battery) {
  battery.ask([]() -> Battery::Numbers {
    expect_a_tree_at_all();
    const Input row = in_a_line(66000, 2);
    const Faults f = faults_of(pt::build_bvh(row.boxes, row.max_leaf), row.boxes, row.max_leaf);
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
}

}  // namespace grader::mistakes
