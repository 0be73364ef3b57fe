#pragma once

#include "grader/check/generators/generators.h"
#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"
#include "pt/math/rgb.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

// Inputs that contracts allow and that random numbers hardly ever meet: components that are zero or
// almost zero, that are equal, and numbers with which no method has to round; and two calls whose
// inputs differ in a single number, or only in the order of two numbers, or in numbers of the same sum.

namespace grader::check {

// 0, -0, and numbers so close to it that their squares are zero. They can still divide a coordinate.
inline constexpr std::array kAlmostZero{0.0, -0.0, 1e-250, -1e-250};

inline rc::Gen<double> almost_zero() {
  return rc::gen::map(whole(0, 3), [](int i) { return kAlmostZero.at(i); });
}

// Three whole numbers from -most to most, not all of them zero. With components of at most 1, this
// is an axis, or exactly between two axes or three.
inline rc::Gen<pt::Vec3> whole_vector(int most) {
  return rc::gen::exec([=] {
    pt::Vec3 v;
    while (v == pt::Vec3{}) {
      v = {*whole(-most, most) * 1.0, *whole(-most, most) * 1.0, *whole(-most, most) * 1.0};
    }
    return v;
  });
}

// A power of two between 2^-most and 2^most.
inline rc::Gen<double> power_of_two(int most) {
  return rc::gen::map(whole(-most, most), [](int i) { return std::pow(2, i); });
}

// The same direction, with 0, -0 or almost zero for each component that is zero. It may be so small
// that its inverse is infinite. Then a plane beside the ray is met at an infinite t: this is for
// rays that meet what they are aimed at.
inline pt::Vec3 with_other_zeros(pt::Vec3 v) {
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  for (int axis = 0; axis < 3; ++axis) {
    if (v[axis] != 0) continue;
    v[axis] = *whole(0, 3) == 3 ? *rc::gen::element(kSmallest, -kSmallest) : *almost_zero();
  }
  return v;
}

// The length of a direction: a billionth to a billion, the ends and a half and two more often, or
// so close to 1 that a tolerance may take it for a unit direction.
inline rc::Gen<double> any_length() {
  return rc::gen::exec([] {
    switch (*whole(0, 3)) {
      case 0:
        return *magnitude(1e-3, 1e3);
      case 1:
        return *magnitude(1e-9, 1e9);
      case 2:
        return *rc::gen::element(1e-9, 0.5, 2.0, 1e9);
      default:
        return 1 + *rc::gen::element(1.0, -1.0) * *magnitude(1e-8, 1e-2);
    }
  });
}

// Any rotation, or one whose z is an axis, almost an axis, or exactly between two axes or three.
inline rc::Gen<pt::Frame> any_frame() {
  return rc::gen::exec([] {
    const int kind = *whole(0, 5);
    if (kind < 3) return *rotation();
    if (kind == 3) return pt::frame_from_normal(normalize(*whole_vector(1)));
    pt::Vec3 z;
    z[*whole(0, 2)] = *rc::gen::element(1.0, -1.0);
    if (kind == 4) return pt::frame_from_normal(z);
    return pt::frame_from_normal(normalize(z + *magnitude(1e-14, 1e-3) * *point(1)));
  });
}

// A number of an input, and another value for it.
struct Change {
  double* number;
  double value;
};
using Changes = std::vector<Change>;

inline Changes changes_of(pt::Vec3& v, double by) {
  return {{&v.x, v.x + by}, {&v.y, v.y + by}, {&v.z, v.z + by}};
}

// A ray that has a hit at t loses it if the range changes.
inline Changes changes_of(pt::Ray& ray, double by, double t) {
  Changes all = changes_of(ray.origin, by);
  for (const Change& each : changes_of(ray.direction, 0.5 * length(ray.direction))) {
    all.push_back(each);
  }
  all.insert(all.end(), {{&ray.t_min, 2 * t}, {&ray.t_max, 0.5 * t}});
  return all;
}

inline Changes joined(std::initializer_list<Changes> parts) {
  Changes all;
  for (const Changes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

inline void make_one_of(const Changes& changes) {
  const Change& change = changes[*whole(0, static_cast<int>(changes.size()) - 1)];
  *change.number = change.value;
}

// Exchanges two numbers of a vector, or two of the vectors: what a task remembers of the numbers without
// their order stays the same.
inline void exchange_in(const std::vector<pt::Vec3*>& vectors) {
  const int last = static_cast<int>(vectors.size()) - 1;
  pt::Vec3 &a = *vectors[*whole(0, last)], &b = *vectors[*whole(0, last)];
  const int axis = *whole(0, 2);
  if (&a != &b) {
    std::swap(a, b);
  } else {
    std::swap(a[axis], a[(axis + 1) % 3]);
  }
}

// The same, or gives one number what another one is, which becomes 0: their sum stays the same, without
// any rounding. The two are of one vector, or of one axis.
inline void exchange_or_add_in(const std::vector<pt::Vec3*>& vectors) {
  if (*whole(0, 1) == 0) return exchange_in(vectors);
  const int last = static_cast<int>(vectors.size()) - 1, axis = *whole(0, 2);
  pt::Vec3 &a = *vectors[*whole(0, last)], &b = *vectors[*whole(0, last)];
  double &more = a[axis], &less = &a == &b ? a[(axis + 1) % 3] : b[axis];
  more += std::exchange(less, 0);
}

// The same of a ray, whose direction keeps a length that contracts name: from a billionth to a billion. What
// is almost zero can be all that an exchange leaves of it.
inline void exchange_or_add_in(pt::Ray& ray) {
  const pt::Vec3 direction = ray.direction;
  exchange_or_add_in({&ray.origin, &ray.direction});
  const double now = length(ray.direction);
  if (!(now >= 1e-9 && now <= 1e9)) ray.direction = direction;
}

// The same of a box, whose sides may have to change places afterwards.
inline void exchange_or_add_in(pt::Box& box) {
  exchange_or_add_in({&box.min, &box.max});
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) std::swap(box.min[axis], box.max[axis]);
  }
}

// The same of a colour, whose channels are at most half of what they may be.
inline void exchange_or_add_in(pt::Rgb& color) {
  const int more = *whole(0, 2), less = (more + *whole(1, 2)) % 3;
  if (*whole(0, 1) == 0) return std::swap(color[more], color[less]);
  color[more] += std::exchange(color[less], 0);
}

// Two calls, one after the other. What a task remembers of the first, by whatever part of it, must
// not be its answer to the second.
template <class Case>
struct InTurn {
  Case before, now;
};

template <class Case>
void showValue(const InTurn<Case>& calls, std::ostream& out) {
  out << "after a call with another input:\n";
  showValue(calls.before, out);
  out << "\nthe call itself:\n";
  showValue(calls.now, out);
}

// The case `now`, and before it the same case after `change`.
template <class Case, class Change>
rc::Gen<InTurn<Case>> in_turn(const rc::Gen<Case>& now, const Change& change) {
  return rc::gen::exec([=] {
    const Case made = *now;
    return InTurn<Case>{change(made), made};
  });
}

}  // namespace grader::check
