// Directions to a rectangle by solid angle, and points that fill a square evenly.
#include "pt/sampling/spherical_rectangle.h"

#include "pt/sampling/quasirandom.h"
#include "tests/proof/closed_forms.h"
#include "tests/proof/directions.h"

#include <cmath>
#include <vector>

namespace pt::proof {
namespace {

struct Seen {
  Vec3 p, center, u, v;

  SphericalRectangle rectangle() const { return spherical_rectangle(p, center, u, v); }
  Polygon polygon() const { return parallelogram(center, u, v); }
};

// From the front and from behind, above the rectangle and far beside it, wide and narrow, at any
// scale: of any place, and of some that are hard.
std::vector<Seen> rectangles() {
  std::vector<Seen> all{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 2, 0}},
                        {{0, 0, 0}, {0, 0, -1e-3}, {1, 0, 0}, {0, 1, 0}},
                        {{0, 0, 0}, {3, 4, 1e-2}, {1, 0, 0}, {0, 1, 0}},
                        {{0, 0, 0}, {.5, .5, 1}, {1, 0, 0}, {0, 1, 0}},
                        {{0, 0, 0}, {0, 0, 1}, {1e3, 0, 0}, {0, 1e-2, 0}}};
  Sampler sampler(71);
  const auto number = [&] { return 2 * sampler.next_1d() - 1; };
  for (int i = 0; i < 200; ++i) {
    const Frame frame = frame_from_normal(normalize({number(), number(), number()}));
    const double scale = std::pow(10, 4 * number());
    const Vec3 p{number(), number(), number()};
    all.push_back({p, p + scale * Vec3{number(), number(), number()},
                   scale * std::pow(10, number()) * frame.x,
                   scale * std::pow(10, number()) * frame.y});
  }
  return all;
}

TEST(SphericalRectangle, has_the_solid_angle_of_its_two_triangles) {
  for (const Seen& seen : rectangles()) {
    const Polygon q = seen.polygon();
    const double expected =
        solid_angle(seen.p, q[0], q[1], q[2]) + solid_angle(seen.p, q[0], q[2], q[3]);
    EXPECT_NEAR(seen.rectangle().solid_angle, expected, 1e-11);
  }
}

// A point of the square is a point of the rectangle, and the corners are the corners.
TEST(SphericalRectangle, maps_the_square_to_the_rectangle) {
  for (const Seen& seen : rectangles()) {
    const SphericalRectangle rectangle = seen.rectangle();
    if (!(rectangle.solid_angle > 1e-6)) continue;
    const auto coordinates = [&](Vec2 xi) {
      const Vec3 q = seen.p + sample_rectangle(rectangle, xi) - seen.center;
      EXPECT_NEAR(dot(q, normalize(cross(seen.u, seen.v))), 0,
                  1e-10 * length(seen.center - seen.p));
      return Vec2{dot(q, seen.u) / length_squared(seen.u) + .5,
                  dot(q, seen.v) / length_squared(seen.v) + .5};
    };
    for (const double a : {0., .3, .999}) {
      for (const double b : {0., .6, .999}) {
        const auto [x, y] = coordinates({a, b});
        EXPECT_TRUE(-1e-9 <= x && x <= 1 + 1e-9 && -1e-9 <= y && y <= 1 + 1e-9) << x << " " << y;
      }
    }
    // At the far end of a long rectangle, a rounding error of the angle is a long way.
    EXPECT_NEAR(coordinates({0, 0}).x, 0, 1e-4);
    EXPECT_NEAR(coordinates({0, 0}).y, 0, 1e-4);
    EXPECT_NEAR(coordinates({1, 1}).x, 1, 1e-4);
    EXPECT_NEAR(coordinates({1, 1}).y, 1, 1e-4);
  }
}

// Uniform inside, and nothing outside: the histogram has the density that integrates to one.
TEST(SphericalRectangle, has_directions_that_are_equally_likely) {
  int tried = 0;
  for (const Seen& seen : rectangles()) {
    const SphericalRectangle rectangle = seen.rectangle();
    if (!(rectangle.solid_angle > .3) || ++tried > 4) continue;
    const Polygon q = seen.polygon();
    const auto density = [&](Vec3 w) {
      bool inside = true;
      const double side = dot(cross(q[0] - seen.p, q[1] - seen.p), seen.center - seen.p);
      for (int i = 0; i < 4; ++i) {
        inside = inside && side * dot(cross(q[i] - seen.p, q[(i + 1) % 4] - seen.p), w) > 0;
      }
      return inside ? 1 / rectangle.solid_angle : 0;
    };
    expect_density(
        Bins{frame_from_normal(rectangle.z), 1},
        [&](Sampler& s) { return normalize(sample_rectangle(rectangle, s.next_2d())); }, density,
        "rectangle " + std::to_string(tried));
  }
  EXPECT_GE(tried, 4);
}

// The mean of cos(wi) / pdf is the irradiance, by Lambert's formula: summed up without randomness,
// over a fine grid of the square.
TEST(SphericalRectangle, brings_the_irradiance_of_the_closed_form) {
  constexpr int kSide = 120;
  int tried = 0;
  for (const Seen& seen : rectangles()) {
    const SphericalRectangle rectangle = seen.rectangle();
    if (!(rectangle.solid_angle > 1e-6) || ++tried > 60) continue;
    const Vec3 n = normalize(rectangle.z + .4 * rectangle.x);
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vec2 xi{(i % kSide + .5) / kSide, (i / kSide + .5) / kSide};
      sum += std::max(0.0, dot(n, normalize(sample_rectangle(rectangle, xi))));
    }
    const double expected = lambert_irradiance(seen.p, n, seen.polygon());
    const double found = sum * rectangle.solid_angle / (kSide * kSide);
    EXPECT_NEAR(found, expected, 2e-4 * rectangle.solid_angle);
  }
  EXPECT_GE(tried, 40);
}

TEST(SphericalRectangle, has_no_solid_angle_in_its_own_plane) {
  EXPECT_EQ(spherical_rectangle({0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {0, 1, 0}).solid_angle, 0);
  EXPECT_EQ(spherical_rectangle({0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}).solid_angle, 0);
}

// Each of 16 equal squares holds a sixteenth of n points, but for a few; with random points that number varies by its
// square root.
TEST(Quasirandom, fills_the_square_evenly) {
  Sampler sampler(72);
  for (int round = 0; round < 50; ++round) {
    const Vec2 start = sampler.next_2d();
    std::vector<int> counts(16);
    for (int i = 0; i < 1600; ++i) {
      const auto [x, y] = low_discrepancy_point(start, i);
      ASSERT_TRUE(0 <= x && x < 1 && 0 <= y && y < 1);
      ++counts[4 * static_cast<int>(4 * y) + static_cast<int>(4 * x)];
    }
    for (const int count : counts) EXPECT_NEAR(count, 100, 6);
  }
}

// For any start, point 0 is the start, and all others keep their places beside it.
TEST(Quasirandom, moves_as_a_whole) {
  const Vec2 here = low_discrepancy_point({.25, .75}, 0), there = low_discrepancy_point({0, 0}, 0);
  EXPECT_EQ(here.x - there.x, .25);
  EXPECT_EQ(here.y - there.y, .75);
  for (int i = 1; i < 100; ++i) {
    const Vec2 a = low_discrepancy_point({.25, .75}, i), b = low_discrepancy_point({0, 0}, i);
    const double dx = a.x - b.x - .25, dy = a.y - b.y - .75;
    EXPECT_NEAR(dx, std::round(dx), 1e-12);
    EXPECT_NEAR(dy, std::round(dy), 1e-12);
  }
}

}  // namespace
}  // namespace pt::proof
