#pragma once

#include "grader/check/language/property.h"
#include "grader/check/language/repetition.h"
#include "grader/check/language/two_numbers.h"
#include "grader/check/scenes/closed_forms.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

// Judges whether points are spread evenly over a pixel, and says where they are not.

namespace grader::check {

using Points = std::vector<pt::Vec2>;  // each in [0, 1] on both axes

// The pixels of the picture that a memory with a coarse key takes for (x, y): x and y exchanged, the same sum, and the same place in a
// list of rows or of columns.
inline std::vector<std::pair<int, int>> pixels_taken_for(int x, int y, int width, int height) {
  std::vector<std::pair<int, int>> all{
      {y, x}, {x + 1, y - 1}, {x - height, y + 1}, {x + 1, y - width}};
  std::erase_if(all, [&](const auto& at) {
    return at.first < 0 || at.second < 0 || at.first >= width || at.second >= height;
  });
  return all;
}

// The number of points in each of side x side parts of the pixel.
class Cells {
 public:
  Cells(const Points& points, int side)
      : side_(side),
        counts_(side * side),
        even_(static_cast<double>(points.size()) / (side * side)) {
    for (const pt::Vec2 at : points) ++counts_[index(at.y) * side + index(at.x)];
  }

  // Returns false for one in a billion sets of right points. Right points are independent, or are
  // pairs that mirror each other. The counts of mirrored pairs vary twice as much.
  bool even() const {
    double chi_square = 0;
    for (const int count : counts_) chi_square += (count - even_) * (count - even_) / even_;
    return chi_square <= 2 * chi_square_limit(side_ * side_ / 2);
  }

  // Describes the part whose count is farthest from the expected one.
  std::string worst() const {
    const auto off = [&](int count) { return std::abs(count - even_); };
    const auto at = std::ranges::max_element(counts_, {}, off);
    const int i = static_cast<int>(at - counts_.begin());
    const int column = i % side_, row = i / side_;
    const double size = 1.0 / side_, x = column * size, y = row * size;
    return fmt::format(
        "{} points where {:.0f} are expected, {:.3f} to {:.3f} from the left and "
        "{:.3f} to {:.3f} from the bottom",
        *at, even_, x, x + size, y, y + size);
  }

 private:
  // A submission's point may be anywhere, or not a number.
  int index(double part) const {
    const double at = part * side_;
    return at > 0 ? static_cast<int>(std::min(at, side_ - 1.0)) : 0;
  }

  int side_;
  std::vector<int> counts_;
  double even_;
};

// Rays through one point may be different by rounding errors.
inline long place(double part) { return std::lround(1e5 * part); }

inline Repetition repeated_places(const Points& points) {
  std::vector<std::pair<long, long>> places;
  for (const pt::Vec2 at : points) places.emplace_back(place(at.x), place(at.y));
  return repetition(places);
}

// Fails the case if more than half of the points have the same x as another one, or the same y: they
// are fixed, the same in each call, or on a coarse grid.
inline void expect_different_coordinates(const Points& points, const std::string& name) {
  std::vector<long> x, y;
  for (const pt::Vec2 at : points) {
    x.push_back(place(at.x));
    y.push_back(place(at.y));
  }
  const auto expect_different = [&](const std::vector<long>& places, const char* edge) {
    const Repetition repeated = repetition(places);
    expect(!repeated.half_are_repeated(),
           fmt::format("{}, at different distances from the {} edge", name, edge),
           fmt::format(
               "only {} different distances: some points are fixed, repeated, or on a coarse grid",
               repeated.different));
  };
  expect_different(x, "left");
  expect_different(y, "bottom");
}

// Fails the case if one point occurs more than four times.
inline void expect_no_frequent_point(const Points& points) {
  const Repetition repeated = repeated_places(points);
  expect(!repeated.one_is_frequent(), fmt::format("{} random points of the pixel", points.size()),
         fmt::format("one point {} times", repeated.most));
}

// Says what uneven points of some calls have in common, in words for a person.
inline std::string what_is_missing(const Points& points, const Cells& cells, std::size_t calls) {
  const std::size_t different = repeated_places(points).different;
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
  if (calls > 1 && different * calls <= n) {
    return fmt::format("{} different points in {} calls of {} samples: each call has the same ones",
                       different, calls, n / calls);
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
inline void expect_even(const Points& points, int calls = 1) {
  const bool repeated = 10 * repeated_places(points).different < 9 * points.size();
  for (const int side : {4, 8}) {
    const Cells cells(points, side);
    if (repeated || !cells.even()) {
      expect(false, "points spread evenly over the pixel", what_is_missing(points, cells, calls));
    }
  }
  expect_no_frequent_point(points);
  expect_different_coordinates(points, fmt::format("{} points", points.size()));
}

// The number of points that expect_independent_axes needs.
inline constexpr int kIndependentPoints = 1200;

// Fails the case if x and y of a point follow from one random number. The points are of different
// calls, so that they are independent, and spread evenly over the pixel.
inline void expect_independent_axes(const Points& points) {
  std::vector<NumberPair> pairs;
  for (const pt::Vec2 at : points) pairs.push_back({at.x, at.y});
  expect_two_numbers("x and y of a point in the pixel", pairs);
}

// Fails the case if a coordinate of the points is often a number that the sampler gives afterwards: a
// point that looks ahead in the sampler shares its number with the path. The points are of different
// calls, with the state of the sampler after each. Of right points, one in 500 is as close by chance.
inline void expect_not_ahead(const Points& points, const std::vector<pt::Sampler::State>& after) {
  for (const bool y : {false, true}) {
    std::array<std::size_t, 2> close{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      pt::Sampler sampler(after[i]);
      for (std::size_t& each : close) {
        each += std::abs((y ? points[i].y : points[i].x) - sampler.next_1d()) < 1e-3;
      }
    }
    if (20 * std::max(close[0], close[1]) < points.size()) continue;
    expect(false, "points that have no number in common with the radiance that follows",
           fmt::format("{} is a number that radiance() draws from the sampler afterwards",
                       y ? "y" : "x"));
  }
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

}  // namespace grader::check
