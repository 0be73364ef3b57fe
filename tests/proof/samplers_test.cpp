#include "pt/sampling/directions.h"
#include "pt/sampling/sampler.h"
#include "tests/proof/directions.h"
#include "tests/proof/statistics.h"

#include <functional>

// The random numbers, and the maps from them to directions.

namespace pt::proof {
namespace {

// ---- numbers in [0, 1)

int bin_of(double xi, int bins) { return static_cast<int>(xi * bins); }

void expect_uniform(const std::vector<double>& counts, double total, const std::string& what) {
  const auto bins = static_cast<double>(counts.size());
  expect_counts(counts, std::vector<double>(counts.size(), total / bins), what);
}

TEST(Sampler, is_uniform_in_one_two_and_three_numbers_in_a_row) {
  constexpr int kBins = 16;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
    Sampler sampler(seed);
    std::vector<double> one(1024), two(kBins * kBins), three(kBins * kBins * kBins);
    const int n = 300000;
    for (int i = 0; i < n; ++i) {
      const Vec2 xi = sampler.next_2d();
      const double third = sampler.next_1d();
      ASSERT_TRUE(xi.x >= 0 && xi.x < 1 && xi.y >= 0 && xi.y < 1 && third >= 0 && third < 1);
      ++one[bin_of(third, 1024)];
      ++two[bin_of(xi.x, kBins) * kBins + bin_of(xi.y, kBins)];
      ++three[(bin_of(xi.x, kBins) * kBins + bin_of(xi.y, kBins)) * kBins + bin_of(third, kBins)];
    }
    expect_uniform(one, n, "one");
    expect_uniform(two, n, "two");
    expect_uniform(three, n, "three");
  }
}

TEST(Sampler, draws_the_lowest_bits_too) {
  Sampler sampler(2);
  std::vector<double> counts(256);
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const auto bits = static_cast<std::uint64_t>(sampler.next_1d() * 0x1p53);
    ++counts[bits & 255];
  }
  expect_uniform(counts, n, "the lowest eight of 53 bits");
}

// A picture uses many short streams. The first numbers of each pixel must be as good as those of a
// long stream, and independent of the neighbours' and of the same pixel's with the next seed.
TEST(Sampler, gives_pixels_independent_streams) {
  constexpr int kSize = 512, kBins = 16;
  const auto draw = [](std::uint64_t seed, int x, int y) {
    return Sampler::for_pixel(seed, x, y).next_2d();
  };
  std::vector<double> own(kBins * kBins), right(kBins * kBins), above(kBins * kBins),
      seed(kBins * kBins), mirrored(kBins * kBins);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const Vec2 xi = draw(5, x, y);
      const int row = bin_of(xi.x, kBins) * kBins;
      ++own[row + bin_of(xi.y, kBins)];
      ++right[row + bin_of(draw(5, x + 1, y).x, kBins)];
      ++above[row + bin_of(draw(5, x, y + 1).x, kBins)];
      ++seed[row + bin_of(draw(6, x, y).x, kBins)];
      if (x != y) ++mirrored[row + bin_of(draw(5, y, x).x, kBins)];
    }
  }
  const double n = kSize * kSize;
  expect_uniform(own, n, "the first two numbers");
  expect_uniform(right, n, "with the pixel to the right");
  expect_uniform(above, n, "with the pixel above");
  expect_uniform(seed, n, "with the next seed");
  // Every pair is counted twice, as (a, b) and (b, a); one half contains each pair once.
  std::vector<double> pairs, expected;
  for (int a = 0; a < kBins; ++a) {
    for (int b = 0; b <= a; ++b) {
      pairs.push_back(mirrored[a * kBins + b] / (a == b ? 2 : 1));
      expected.push_back((n - kSize) / 2 / (kBins * kBins) * (a == b ? 1 : 2));
    }
  }
  expect_counts(pairs, expected, "with the pixel mirrored at the diagonal");
}

// ---- directions

TEST(Directions, have_the_density_they_say) {
  const Bins all;
  expect_density(
      all, [](Sampler& s) { return uniform_hemisphere(s.next_2d()); },
      [](Vec3 w) { return w.z > 0 ? 1 / (2 * kPi) : 0; }, "uniform_hemisphere");
  expect_density(
      all, [](Sampler& s) { return cosine_hemisphere(s.next_2d()); },
      [](Vec3 w) { return (w.z > 0 ? w.z : 0) / kPi; }, "cosine_hemisphere");
  for (const double h : {1.5, 0.1, 1e-4, 1e-9}) {
    expect_density(
        Bins{{}, h}, [h](Sampler& s) { return uniform_cone(s.next_2d(), h); },
        [h](Vec3) { return 1 / (2 * kPi * h); }, "uniform_cone");
  }
}

// ---- the maps' Jacobians

// The area on the sphere of a small square of xi, by central differences with step h. The error is
// about h^2 times third derivatives (some 250 for a whole turn) plus 2^-52 / h.
double jacobian(const std::function<Vec3(Vec2)>& map, Vec2 xi) {
  const double h = 1e-5;
  const Vec3 along_x = (map({xi.x + h, xi.y}) - map({xi.x - h, xi.y})) / (2 * h);
  const Vec3 along_y = (map({xi.x, xi.y + h}) - map({xi.x, xi.y - h})) / (2 * h);
  return length(cross(along_x, along_y));
}

TEST(Directions, stretch_the_square_as_their_density_says) {
  Sampler sampler(53);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 square = sampler.next_2d();
    const Vec2 xi{0.05 + 0.9 * square.x, square.y};
    EXPECT_NEAR(jacobian(uniform_hemisphere, xi) / (2 * kPi), 1, 1e-6);
    EXPECT_NEAR(jacobian(cosine_hemisphere, xi) * cosine_hemisphere(xi).z / kPi, 1, 1e-6);
    for (const double h : {1.5, 0.1, 1e-3}) {
      const auto cone = [h](Vec2 v) { return uniform_cone(v, h); };
      EXPECT_NEAR(jacobian(cone, xi) / (2 * kPi * h), 1, 1e-6);
    }
  }
}

}  // namespace
}  // namespace pt::proof
