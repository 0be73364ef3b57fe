#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/generators/special.h"
#include "grader/check/language/show.h"
#include "pt/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Boxes in all arrangements that are difficult for a splitting rule.

namespace grader::check::build_bvh_inputs {

using Boxes = std::vector<pt::Box>;

struct Input {
  Boxes boxes;
  int max_leaf = 1;
  std::string how{};  // how the boxes were made
};

// Shows all boxes if there are up to six, else the first three. `how` describes all of them in
// words.
inline void showValue(const Input& input, std::ostream& out) {
  const std::size_t n = input.boxes.size(), shown = n <= 6 ? n : 3;
  out << n << (n == 1 ? " box, " : " boxes, ") << input.how << "; max_leaf " << input.max_leaf;
  for (std::size_t i = 0; i < shown; ++i) {
    out << "\nbox " << i << ": " << show(input.boxes[i]);
  }
  if (shown < n) out << "\nand " << n - shown << " more";
}

inline pt::Box around(pt::Vec3 center, pt::Vec3 half) { return {center - half, center + half}; }

enum class Kind {
  scattered,
  clustered,
  points,
  flat,
  nested,
  line,
  from_a_corner,
  halving,
  both_ends,
  identical,
  same_center,
  in_piles,
  lattice,
  diagonal,
};

// A plane in the middle of the longest axis divides these kinds.
inline const std::vector<Kind> kUsual{Kind::scattered,    Kind::clustered, Kind::points,
                                      Kind::flat,         Kind::nested,    Kind::line,
                                      Kind::from_a_corner};
// A plane in the middle cuts off only one box, so that the tree has as many levels as boxes.
inline const std::vector<Kind> kDeep{Kind::halving};
// No plane separates all of these boxes.
inline const std::vector<Kind> kCoinciding{Kind::identical, Kind::same_center, Kind::in_piles,
                                           Kind::both_ends};
// In these kinds, no axis is longer than the others.
inline const std::vector<Kind> kTied{Kind::lattice, Kind::diagonal};

inline const char* words(Kind kind) {
  switch (kind) {
    case Kind::scattered:
      return "scattered";
    case Kind::clustered:
      return "in three small clusters";
    case Kind::points:
      return "each of them a point";
    case Kind::flat:
      return "all flat, their centres in one plane";
    case Kind::nested:
      return "of all sizes, most of them one inside the other";
    case Kind::line:
      return "in a line along one axis";
    case Kind::from_a_corner:
      return "of different sizes, with their lower corners in one place";
    case Kind::halving:
      return "points, each half as far from the first corner as the one before";
    case Kind::both_ends:
      return "points that get closer to both ends of a line, until they coincide";
    case Kind::identical:
      return "all the same";
    case Kind::same_center:
      return "of different sizes around the same centre";
    case Kind::in_piles:
      return "in four piles of identical boxes";
    case Kind::lattice:
      return "in a cube of rows, as long in x as in y and z";
    case Kind::diagonal:
      return "along a diagonal, as long in x as in y and z";
  }
  return "";
}

// The centre and half the size of one box. The centre of a usual kind is within about 10 of the
// origin.
struct Place {
  pt::Vec3 center, half;
};

inline pt::Vec3 on_axis(int axis, double at) {
  pt::Vec3 p;
  p[axis] = at;
  return p;
}

// Returns the place of one box of a usual kind.
inline Place usual_place(Kind kind, int axis, RandomNumbers& make) {
  const pt::Vec3 p = make.vector(-10, 10);
  switch (kind) {
    case Kind::clustered: {
      const double cluster = 5 * make.whole(0, 2);
      return {pt::Vec3{cluster, -cluster, 1} + 1e-6 * p, make.vector(1e-9, 1e-7)};
    }
    case Kind::points:
      return {p, {}};
    case Kind::flat: {
      pt::Vec3 half = make.vector(0.01, 1);
      half[make.whole(0, 2)] = 0;
      return {{p.x, 0, p.z}, half};
    }
    case Kind::nested:
      return {0.1 * p, std::pow(10, make.between(-4, 2)) * pt::Vec3{1, 1, 1}};
    case Kind::line:
      return {on_axis(axis, p.x), make.vector(0, 0.1)};
    case Kind::from_a_corner: {
      const pt::Vec3 half = make.vector(0.01, 3);
      return {half, half};
    }
    default:
      return {p, make.vector(0.01, 3)};
  }
}

inline Place place(Kind kind, int i, int n, int axis, RandomNumbers& make) {
  const int side = static_cast<int>(std::round(std::cbrt(n)));
  const double pile = 3 * make.whole(0, 3);
  switch (kind) {
    case Kind::halving:
      return {on_axis(axis, 8 * std::pow(2, -i)), {}};
    case Kind::both_ends:
      return {on_axis(axis, i % 2 == 0 ? 8 * std::pow(2, -i / 2) : 8 - 4 * std::pow(2, -i / 2)),
              {}};
    case Kind::identical:
      return {{2.5, 3.5, 4.5}, {1.5, 1.5, 1.5}};
    case Kind::same_center:
      return {{}, make.vector(0, 1)};
    case Kind::in_piles:
      return {{pile, 1, -2 * pile}, {1, 1, 1}};
    case Kind::lattice: {
      const int x = i % side, y = i / side % side, z = i / side / side;
      return {pt::Vec3{1.0 * x, 1.0 * y, 1.0 * z}, {0.25, 0.25, 0.25}};
    }
    case Kind::diagonal:
      return {pt::Vec3{1.0, 1.0, 1.0} * i, {0.25, 0.25, 0.25}};
    default:
      return usual_place(kind, axis, make);
  }
}

// Returns how many boxes fill a cube: a cubic number near n, at least eight.
inline int full_cube(int n) {
  const int side = std::max(2, static_cast<int>(std::round(std::cbrt(n))));
  return side * side * side;
}

// Returns n boxes of one kind. Of some kinds, the order of the boxes is that of their places.
inline Boxes boxes_of_kind(Kind kind, int n, int axis, RandomNumbers& make, double scale = 1,
                           pt::Vec3 shift = {}) {
  Boxes boxes;
  for (int i = 0; i < n; ++i) {
    const auto [center, half] = place(kind, i, n, axis, make);
    boxes.push_back(around(scale * center + shift, scale * half));
  }
  return boxes;
}

inline Boxes scattered(int n, RandomNumbers& make) {
  return boxes_of_kind(Kind::scattered, n, 0, make);
}

// Boxes of the given kinds, from a billionth to a billion across. The usual kinds may also be far
// from the origin.
inline rc::Gen<Input> boxes_of(const std::vector<Kind>& kinds, int least, int most) {
  return rc::gen::exec([=] {
    const int wanted = *whole(least, most);
    Input input{{}, *rc::gen::element(1, 2, 3, 4, 7, 16, 1000)};
    RandomNumbers make(*sampler_seed());
    const Kind kind = *rc::gen::elementOf(kinds);
    const int n = kind == Kind::lattice ? full_cube(wanted) : wanted;
    const int axis = *whole(0, 2);
    const double scale = *whole(0, 2) == 0 ? 1 : *magnitude(1e-10, 1e8);
    const bool usual = std::ranges::find(kUsual, kind) != kUsual.end();
    const pt::Vec3 shift = usual && *whole(0, 3) == 3 ? scale * *point(1e4) : pt::Vec3{};
    input.boxes = boxes_of_kind(kind, n, axis, make, scale, shift);
    make.shuffle(input.boxes);
    input.how = words(kind);
    return input;
  });
}

// A few boxes of the usual kinds, or many.
inline rc::Gen<Input> some_boxes() {
  return rc::gen::exec(
      [] { return *whole(0, 2) == 0 ? *boxes_of(kUsual, 1, 5) : *boxes_of(kUsual, 6, 200); });
}
inline rc::Gen<Input> thousands_of_boxes() { return boxes_of(kUsual, 2000, 3000); }
inline rc::Gen<Input> deep_boxes() { return boxes_of(kDeep, 30, 400); }

// More than a thousand boxes that no plane separates, one per leaf.
inline rc::Gen<Input> a_large_pile(Kind kind) {
  return rc::gen::map(boxes_of({kind}, 1100, 2500), [](Input input) {
    input.max_leaf = 1;
    return input;
  });
}

// Points at first * 2^-i for i = 0, 1, ...
inline Input halving_points(int axis, int n, double first = 1, int max_leaf = 1) {
  Input input{{}, max_leaf};
  for (int i = 0; i < n; ++i) {
    input.boxes.push_back(around(on_axis(axis, first * std::pow(2, -i)), {0, 0, 0}));
  }
  return input;
}

// So many points, each half as far from the first corner as the point before, one per leaf.
inline rc::Gen<Input> halvings(int points) {
  return rc::gen::exec([=] {
    const int axis = *whole(0, 2);
    RandomNumbers make(*sampler_seed());
    Input input{boxes_of_kind(Kind::halving, points, axis, make), 1, words(Kind::halving)};
    make.shuffle(input.boxes);
    return input;
  });
}

// Boxes in a line, one unit apart, in its order.
inline Input in_a_line(int boxes, int max_leaf) {
  Input row{{}, max_leaf, "in a row along the x axis"};
  row.boxes.reserve(boxes);
  for (int i = 0; i < boxes; ++i) row.boxes.push_back(around({1.0 * i, 0, 0}, {0.4, 1, 1}));
  return row;
}

// The same with two boxes exchanged, or with other numbers of the same sum in a box.
inline Input exchanged(Input input) {
  const int last = static_cast<int>(input.boxes.size()) - 1;
  pt::Box &box = input.boxes[*whole(0, last)], &other = input.boxes[*whole(0, last)];
  if (&box != &other && *whole(0, 1) == 0) {
    std::swap(box, other);
  } else {
    exchange_or_add_in(box);
  }
  return input;
}

// The same with one number changed: the largest corner of the first, the last or any box, the number
// of boxes, or max_leaf; or with numbers exchanged.
inline Input changed(Input input) {
  const int last = static_cast<int>(input.boxes.size()) - 1, kind = *whole(0, 8);
  if (kind > 5) return exchanged(input);
  if (kind == 0) input.max_leaf = 2 * input.max_leaf + 1;
  if (kind == 1) input.boxes.push_back(input.boxes[0]);
  if (kind == 2 && last > 0) input.boxes.pop_back();
  if (kind < 3) return input;
  pt::Vec3& corner = input.boxes[kind == 3 ? 0 : kind == 4 ? last : *whole(0, last)].max;
  make_one_of(changes_of(corner, 1e-3 + max_abs(corner)));
  return input;
}

// Twenty boxes at two places: ten points at one and then ten at the other, or flat boxes in turn.
inline Boxes in_two_piles(bool in_turn) {
  Boxes boxes;
  for (int i = 0; i < 20; ++i) {
    boxes.push_back(in_turn ? around({1.0 * (i % 2), 3, 0}, {0.1, 0, 0.1})
                            : around({i < 10 ? 0.0 : 1.0, 0, 0}, {0, 0, 0}));
  }
  return boxes;
}

// One row of boxes along an axis, or several parallel rows, side by side along a second, longer
// axis.
struct Rows {
  int along = 0;   // the axis of a row
  int across = 1;  // the axis on which the rows lie side by side
  int count = 1, each = 64;
  double length = 64;  // of a row
  pt::Vec3 corner{};
  double jitter = 1e-2;  // in lengths of a row, on the axis after that of a row
  int flat = -1;         // the axis on which all boxes are flat and in one plane, or -1
  bool sticks = false;   // longer than the row, along the third axis
};

// The boxes are in random order. They are also moved a little on both axes across a row, ten
// thousand times as far on one axis as on the other. This is less than their own size, so that a
// split on these axes separates nothing.
inline Boxes boxes_in(const Rows& rows, RandomNumbers& make) {
  const auto& [along, across, count, each, length, corner, jitter, flat, sticks] = rows;
  pt::Vec3 moved, half{0.01 * length, 0.01 * length, 0.01 * length};
  moved[(along + 1) % 3] = jitter * length;
  moved[(along + 2) % 3] = 1e-8 * length * length / moved[(along + 1) % 3];
  half[along] = 0.4 * length / each;
  if (flat >= 0) moved[flat] = half[flat] = 0;
  if (sticks) half[3 - along - across] = 0.75 * length;
  Boxes boxes;
  for (int row = 0; row < count; ++row) {
    for (int i = 0; i < each; ++i) {
      pt::Vec3 p = corner;
      for (int axis = 0; axis < 3; ++axis) p[axis] += make.between(0, moved[axis]);
      p[along] += length * i / each;
      p[across] += 3 * length * row / count;
      boxes.push_back(around(p, half));
    }
  }
  make.shuffle(boxes);
  return boxes;
}

inline std::string words(const Rows& rows) {
  const std::string axes = "xyz";
  const std::string flat = rows.flat < 0 ? "" : std::string(", all flat in ") + axes[rows.flat];
  const std::string shape = rows.sticks ? ", of boxes that are longer than the row" : flat;
  const std::string row = show(rows.length) + " long along " + axes[rows.along] + shape;
  return rows.count == 1 ? "in one row, in no order, " + row
                         : "in " + std::to_string(rows.count) + " rows, in no order, each " + row +
                               ", side by side along " + axes[rows.across];
}

struct InRows {
  Rows rows;
  Input input;
};

inline void showValue(const InRows& made, std::ostream& out) { showValue(made.input, out); }

inline rc::Gen<InRows> in_rows(int along, int count, int each) {
  return rc::gen::exec([=] {
    const int max_leaf = *whole(1, 4);
    Rows rows{.along = along, .across = (along + *whole(1, 2)) % 3, .count = count, .each = each};
    rows.length = *magnitude(1e-9, 1e9);
    rows.corner = rows.length * *point(5);
    rows.jitter = *rc::gen::element(1e-6, 1e-2);
    const int kind = *whole(0, 3);
    if (kind == 1 || kind == 2) rows.flat = (along + kind) % 3;
    rows.sticks = kind == 3;
    RandomNumbers make(*sampler_seed());
    return InRows{rows, {boxes_in(rows, make), max_leaf, words(rows)}};
  });
}

}  // namespace grader::check::build_bvh_inputs
