#pragma once

#include "grader/check/closed_forms.h"
#include "grader/check/property.h"
#include "pt/math/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

// Judges whether points are spread evenly over a pixel, and says where they are not.

namespace grader::check::estimate_pixel_cases {

using Points = std::vector<pt::Vec2>;  // each in [0, 1] on both axes

// The number of points in each of 8 x 8 parts of the pixel.
class Cells {
 public:
  static constexpr int kSide = 8;

  explicit Cells(const Points& points)
      : even_(static_cast<double>(points.size()) / (kSide * kSide)) {
    for (const pt::Vec2 at : points) ++counts_[index(at.y) * kSide + index(at.x)];
  }

  // Returns false for one in a billion sets of right points. Right points are independent, or are
  // pairs that mirror each other. The counts of mirrored pairs vary twice as much.
  bool even() const {
    double chi_square = 0;
    for (const int count : counts_) chi_square += (count - even_) * (count - even_) / even_;
    return chi_square <= 2 * chi_square_limit(kSide * kSide / 2);
  }

  // Describes the part whose count is farthest from the expected one.
  std::string worst() const {
    const auto off = [&](int count) { return std::abs(count - even_); };
    const auto at = std::ranges::max_element(counts_, {}, off);
    const int i = static_cast<int>(at - counts_.begin());
    const double x = static_cast<double>(i % kSide) / kSide,
                 y = static_cast<double>(i / kSide) / kSide;
    return fmt::format(
        "{} points where {:.0f} are expected, {:.3f} to {:.3f} from the left and "
        "{:.3f} to {:.3f} from the bottom",
        *at, even_, x, x + 1.0 / kSide, y, y + 1.0 / kSide);
  }

 private:
  static int index(double part) { return std::clamp(static_cast<int>(part * kSide), 0, kSide - 1); }

  std::array<int, kSide * kSide> counts_{};
  double even_;
};

// Returns how many points are in places of their own. Rays through one point may be different by
// rounding errors.
inline std::size_t different_points(const Points& points) {
  constexpr double kPlaces = 1e5;
  std::set<std::pair<long, long>> different;
  for (const pt::Vec2 at : points) {
    different.insert({std::lround(kPlaces * at.x), std::lround(kPlaces * at.y)});
  }
  return different.size();
}

// Says what uneven points have in common, in words for a person.
inline std::string what_is_missing(const Points& points, const Cells& cells) {
  const std::size_t different = different_points(points);
  pt::Vec2 low{1, 1}, high{0, 0};
  bool diagonal = true;
  for (const pt::Vec2 at : points) {
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    diagonal = diagonal && std::abs(at.x - at.y) < 5e-3;
  }
  const std::size_t n = points.size();
  if (different == 1) {
    return fmt::format(
        "all {} points in one place, {:.3f} from the left and {:.3f} from the bottom", n,
        points[0].x, points[0].y);
  }
  if (10 * different < 9 * n) {
    return fmt::format("only {} different points among {}", different, n);
  }
  if (diagonal) return "all points on the diagonal: x and y are the same number";
  if (low.x > 0.06 || low.y > 0.06 || high.x < 0.94 || high.y < 0.94) {
    return fmt::format(
        "points only from {:.2f} to {:.2f} of the width and {:.2f} to {:.2f} of "
        "the height",
        low.x, high.x, low.y, high.y);
  }
  return cells.worst();
}

// Fails the case if points are uneven, or if many are the same, as on a coarse grid, with a sentence
// that says where they are missing.
inline void expect_even(const Points& points) {
  const Cells cells(points);
  if (cells.even() && 10 * different_points(points) >= 9 * points.size()) return;
  expect(false, "points spread evenly over the pixel", what_is_missing(points, cells));
}

// Fails the case if none of 16,000 points lies in the outermost 1.2 thousandths at one of the edges,
// or in the outermost 0.45 thousandths at any of them. Of right points, 19 are expected at each
// edge, and 29 at any. Even if they are pairs that mirror each other, they are all missing less than
// once in a million times.
inline void expect_points_at_the_edges(const Points& points) {
  std::array<std::pair<const char*, double>, 4> edges{
      {{"left", 1}, {"right", 1}, {"bottom", 1}, {"top", 1}}};
  for (const pt::Vec2 at : points) {
    const std::array<double, 4> away{at.x, 1 - at.x, at.y, 1 - at.y};
    for (std::size_t i = 0; i < edges.size(); ++i) {
      edges[i].second = std::min(edges[i].second, away[i]);
    }
  }
  const auto by_distance = &std::pair<const char*, double>::second;
  const auto [closest, farthest] = std::ranges::minmax(edges, {}, by_distance);
  const auto say = [&](const auto& edge) {
    return fmt::format("the closest is {:.5f} of the pixel away from the {} edge", edge.second,
                       edge.first);
  };
  const std::string right =
      fmt::format("{} points that reach all edges of the pixel", points.size());
  expect(farthest.second < 1.2e-3, right, say(farthest));
  expect(closest.second < 4.5e-4, right, say(closest));
}

}  // namespace grader::check::estimate_pixel_cases
