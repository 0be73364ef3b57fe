#pragma once

#include "grader/property/generators.h"
#include "grader/property/many.h"
#include "grader/property/show.h"
#include "pt/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

// Boxes in all the arrangements that a splitting rule may stumble over.

namespace grader::build_bvh_cases {

struct Input {
  std::vector<pt::Box> boxes;
  int max_leaf = 1;
};

inline void showValue(const Input& input, std::ostream& out) {
  constexpr std::size_t kShown = 6;
  out << input.boxes.size() << " boxes, max_leaf " << input.max_leaf;
  for (std::size_t i = 0; i < std::min(kShown, input.boxes.size()); ++i) {
    out << "\n" << show(input.boxes[i]);
  }
  if (input.boxes.size() > kShown) out << "\nand so on";
}

inline pt::Box around(pt::Vec3 center, pt::Vec3 half) { return {center - half, center + half}; }

enum class Kind { scattered, clustered, points, flat, nested, identical, same_center };

inline pt::Box box_of(Kind kind, Many& make) {
  const pt::Vec3 p = make.vector(-10, 10);
  switch (kind) {
    case Kind::scattered:
      return around(p, make.vector(0.01, 3));
    case Kind::clustered: {
      const double cluster = 5 * make.whole(0, 2);
      return around(pt::Vec3{cluster, -cluster, 1} + 1e-6 * p, make.vector(1e-9, 1e-7));
    }
    case Kind::points:
      return {p, p};
    case Kind::flat: {
      pt::Vec3 half = make.vector(0.01, 1);
      half[make.whole(0, 2)] = 0;
      return around({p.x, 0, p.z}, half);
    }
    case Kind::nested:
      return around(0.1 * p, std::pow(10, make.between(-4, 2)) * pt::Vec3{1, 1, 1});
    case Kind::identical:
      return {{1, 2, 3}, {4, 5, 6}};
    case Kind::same_center:
      return around({0, 0, 0}, make.vector(0, 1));
  }
  return {};
}

inline rc::Gen<Input> boxes_of(const std::vector<Kind>& kinds, int least, int most) {
  return rc::gen::exec([=] {
    const int n = *whole(least, most);
    Input input{{}, *whole(1, 9)};
    Many make(*sampler_seed());
    const Kind kind = *rc::gen::elementOf(kinds);
    for (int i = 0; i < n; ++i) input.boxes.push_back(box_of(kind, make));
    return input;
  });
}

inline const std::vector<Kind> kAll{Kind::scattered, Kind::clustered, Kind::points,     Kind::flat,
                                    Kind::nested,    Kind::identical, Kind::same_center};

inline rc::Gen<Input> some_boxes() { return boxes_of(kAll, 1, 200); }

// Boxes one beside the other along an axis, in no order: one row, or several parallel rows side by
// side along a second, longer axis. The whole stands anywhere. On each axis the boxes also stand a
// little out of line, on one axis ten thousand times as far as on the other; less than their own
// size, so that splitting there separates nothing.
struct Rows {
  Input input;
  int along = 0;   // the axis of a row
  int across = 0;  // the axis on which the rows lie side by side
  double length = 1, width = 1;
  pt::Vec3 corner;
};

inline void showValue(const Rows& rows, std::ostream& out) {
  out << "rows along axis " << rows.along << ", " << rows.length
      << " long, side by side along axis " << rows.across << "\n";
  showValue(rows.input, out);
}

inline rc::Gen<Rows> in_rows(int along, int count, int each) {
  return rc::gen::exec([=] {
    Rows rows;
    rows.input.max_leaf = *whole(1, 4);
    rows.along = along;
    rows.across = (rows.along + *whole(1, 2)) % 3;
    const double scale = *magnitude(1e-6, 1e6);
    rows.length = scale;
    rows.width = count > 1 ? 3 * scale : 0;
    rows.corner = scale * *point(5);
    pt::Vec3 jitter, half{0.01 * scale, 0.01 * scale, 0.01 * scale};
    jitter[(along + 1) % 3] = *rc::gen::element(1e-6, 1e-2) * scale;
    jitter[(along + 2) % 3] = 1e-8 * scale * scale / jitter[(along + 1) % 3];
    half[along] = 0.4 * scale / each;
    Many make(*sampler_seed());
    for (int row = 0; row < count; ++row) {
      for (int i = 0; i < each; ++i) {
        pt::Vec3 p = rows.corner;
        for (int axis = 0; axis < 3; ++axis) p[axis] += make.between(0, jitter[axis]);
        p[rows.along] += scale * i / each;
        p[rows.across] += rows.width * row / count;
        rows.input.boxes.push_back(around(p, half));
      }
    }
    make.shuffle(rows.input.boxes);
    return rows;
  });
}

}  // namespace grader::build_bvh_cases
