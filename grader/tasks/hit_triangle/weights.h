#pragma once

#include "grader/check/generators/generators.h"

#include <algorithm>
#include <array>

// Weights of points in the plane of a triangle.

namespace grader::check::hit_triangle_inputs {

struct Weights {
  double b0, b1, b2;  // sum to 1
};

// `small` and `other` are the weights of two corners; `first` says in which order all three are.
inline Weights weights_of(double small, double other, int first) {
  std::array<double, 3> b{small, other, 1 - small - other};
  std::rotate(b.begin(), b.begin() + first, b.end());
  return {b[0], b[1], b[2]};
}

// Weights of a point well inside: none is below 1/20.
inline Weights inside() {
  const double a = *real(0.05, 1), b = *real(0.05, 1), c = *real(0.05, 1);
  const double sum = a + b + c;
  return {0.9 * a / sum + 1.0 / 30, 0.9 * b / sum + 1.0 / 30, 0.9 * c / sum + 1.0 / 30};
}

// Weights of a point inside, but close to an edge or, with two small weights, to a corner.
inline Weights just_inside() {
  const double small = *magnitude(2e-5, 1e-2), other = *real(0, 1) < 0.5 ? 0.4 : 2e-5;
  return weights_of(small, other, *whole(0, 2));
}

// Weights of a point beyond one or two edges, by 2e-5 to ten times the size of the triangle.
inline Weights outside() {
  const double beyond = -*magnitude(2e-5, 10), other = *real(-3, 3);
  return weights_of(beyond, other, *whole(0, 2));
}

// Weights of a point in the middle.
inline Weights in_the_middle() {
  const double a = *real(0.8, 1.2), b = *real(0.8, 1.2), c = *real(0.8, 1.2), sum = a + b + c;
  return {a / sum, b / sum, c / sum};
}

// Weights of a point on either side of an edge, at least four times as far from it as the precision
// of the cases in kPrecise.
inline Weights very_close(double side, double least = 1e-7, double most = 2e-5) {
  const double small = side * *magnitude(least, most), other = *real(0.1, 0.8);
  return weights_of(small, other, *whole(0, 2));
}
inline Weights barely_inside() { return very_close(1); }
inline Weights barely_outside() { return very_close(-1); }

// The same for the cases in kMostPrecise, at four to nine times their precision.
inline Weights a_hair_inside() { return very_close(1, 9e-9, 2e-8); }
inline Weights a_hair_outside() { return very_close(-1, 9e-9, 2e-8); }

// Multiples of an eighth: of a point inside, and of a point beyond an edge that lies exactly on the
// line of another edge.
inline Weights inside_in_eighths() {
  const int first = *whole(1, 6), second = *whole(1, 7 - first);
  return {first / 8.0, second / 8.0, (8 - first - second) / 8.0};
}
inline Weights outside_on_an_edges_line() {
  const double beyond = -*rc::gen::element(0.125, 0.25, 1.0, 4.0);
  return *whole(0, 1) == 0 ? weights_of(beyond, 0, *whole(0, 2))
                           : weights_of(0, beyond, *whole(0, 2));
}

// Fixed weights of points inside, and of points beyond each edge and each corner.
inline constexpr Weights kInside[] = {{.2, .3, .5}, {.6, .1, .3}, {.1, .8, .1}};
inline constexpr Weights kOutside[] = {{-.3, .6, .7},   {.6, -.3, .7},   {.6, .7, -.3},
                                       {1.9, -.4, -.5}, {-.4, 1.9, -.5}, {-.4, -.5, 1.9}};
inline constexpr Weights kMiddle{.3, .3, .4};

}  // namespace grader::check::hit_triangle_inputs
