// right: the three equations by Gaussian elimination, rows and functions in standard containers
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace pt {

namespace {

using Row = std::array<double, 4>;  // three coefficients, and what they add up to

std::optional<std::vector<double>> solve(std::vector<Row> rows) {
  for (int column = 0; column < 3; ++column) {
    const auto by_size = [column](const Row& a, const Row& b) {
      return std::abs(a[column]) < std::abs(b[column]);
    };
    std::iter_swap(rows.begin() + column,
                   std::max_element(rows.begin() + column, rows.end(), by_size));
    if (rows[column][column] == 0) return std::nullopt;
    for (int below = column + 1; below < 3; ++below) {
      const double factor = rows[below][column] / rows[column][column];
      for (int i = column; i < 4; ++i) rows[below][i] -= factor * rows[column][i];
    }
  }
  std::vector<double> x(3);
  for (int i = 2; i >= 0; --i) {
    const double known =
        std::inner_product(rows[i].begin() + i + 1, rows[i].begin() + 3, x.begin() + i + 1, 0.0);
    x[i] = (rows[i][3] - known) / rows[i][i];
  }
  return x;
}

}  // namespace

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  std::vector<Row> rows;
  for (int axis = 0; axis < 3; ++axis) {
    rows.push_back({triangle.p1[axis] - triangle.p0[axis], triangle.p2[axis] - triangle.p0[axis],
                    -ray.direction[axis], ray.origin[axis] - triangle.p0[axis]});
  }
  const auto solution = solve(rows);
  if (!solution) return std::nullopt;
  const double b1 = (*solution)[0], b2 = (*solution)[1], t = (*solution)[2];
  const std::array<double, 3> weights{1 - b1 - b2, b1, b2};
  const std::function<bool(double)> negative = [](double weight) { return !(weight >= 0); };
  if (std::any_of(weights.begin(), weights.end(), negative)) return std::nullopt;
  if (!(ray.t_min <= t && t <= ray.t_max)) return std::nullopt;
  return SurfaceHit{
      t, normalize(weights[0] * triangle.n0 + weights[1] * triangle.n1 + weights[2] * triangle.n2)};
}

}  // namespace pt
