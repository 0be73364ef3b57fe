#include "pt/image/image.h"

#include "pt/error.h"
#include "pt/image/compare.h"
#include "pt/image/film.h"
#include "pt/image/sample_map.h"
#include "pt/image/tone_map.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace pt {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(RunningMoments, of_two_samples_are_those_by_hand) {
  RunningMoments moments;
  EXPECT_EQ(moments.variance(), (Rgb{0, 0, 0}));
  moments.add({1, 2, 4});
  EXPECT_EQ(moments.variance(), (Rgb{0, 0, 0}));
  EXPECT_EQ(moments.variance_y(), 0);
  moments.add({3, 2, 0});
  EXPECT_EQ(moments.samples(), 2);
  EXPECT_EQ(moments.mean(), (Rgb{2, 2, 2}));
  EXPECT_EQ(moments.variance(), (Rgb{2, 0, 8}));
  // Y is 1.9318, then 2.0682, so the variance is half the square of their difference. The channels
  // move against each other, so no sum of their variances comes near.
  EXPECT_NEAR(moments.mean_y(), 2, 1e-15);
  EXPECT_NEAR(moments.variance_y(), 0.5 * 0.1364 * 0.1364, 1e-15);
}

TEST(RunningMoments, of_a_constant_have_exactly_no_variance) {
  for (const Rgb& constant : {Rgb{0.1, 1.0 / 3, 0.7}, Rgb{1e-300, 1e300, 12345.678}, Rgb{}}) {
    RunningMoments moments;
    for (int i = 0; i < 1000; ++i) moments.add(constant);
    EXPECT_EQ(moments.mean(), constant);
    EXPECT_EQ(moments.variance(), (Rgb{0, 0, 0}));
    EXPECT_EQ(moments.variance_y(), 0);
  }
}

// The relative error of Welford's variance is below about n eps k, with k = sqrt(1 + mean^2 /
// variance) (Chan, Golub, LeVeque 1983); the difference of two sums would lose n eps k^2.
TEST(RunningMoments, agree_with_two_passes_far_from_zero) {
  constexpr int kCount = 1000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> values;
  RunningMoments moments;
  for (int i = 0; i < kCount; ++i) {
    values.push_back(1e4 + uniform(random));
    moments.add({values.back(), uniform(random), 0});
  }
  long double mean = 0, squares = 0;
  for (const double v : values) mean += v;
  mean /= kCount;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double variance = static_cast<double>(squares / (kCount - 1));
  const double eps = std::numeric_limits<double>::epsilon();
  const double k = std::sqrt(1 + 1e8 / variance);
  EXPECT_NEAR(moments.variance().r / variance, 1, kCount * eps * k);
  EXPECT_NEAR(moments.mean().r / static_cast<double>(mean), 1, kCount * eps);
}

TEST(Film, keeps_each_pixel_in_its_place) {
  Film film(3, 2);
  film.set(2, 0, {{1, 2, 3}, {4, 5, 6}, 7, 8});
  EXPECT_EQ(film.pixels[2].mean, (Rgb{1, 2, 3}));
  film.set(0, 1, {{9, 9, 9}, {}, 0, 1});
  const Image image = mean(film);
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels[3], (Rgb{9, 9, 9}));
  EXPECT_EQ(image.at(2, 0), (Rgb{1, 2, 3}));
}

TEST(ToneMap, has_the_values_worked_out_by_hand) {
  EXPECT_EQ(encode(0), 0);
  EXPECT_EQ(encode(0.001), 11);  // 11.04
  EXPECT_EQ(encode(0.18), 117);  // 116.96
  EXPECT_EQ(encode(0.5), 186);   // 186.08
  EXPECT_EQ(encode(0.25, 2), 186);
  EXPECT_EQ(encode(1), 255);
  EXPECT_EQ(encode(7), 255);
  EXPECT_EQ(encode(kInf), 255);
  EXPECT_EQ(encode(-kInf), 0);
  EXPECT_EQ(encode(-0.5), 0);
  EXPECT_EQ(encode(kNan), 0);
  EXPECT_EQ(encode(kInf, 0), 0);
}

TEST(ToneMap, rounds_to_the_nearest_code) {
  for (int code = 0; code < 255; ++code) {
    EXPECT_EQ(encode(std::pow((code + 0.49) / 255, 2.2)), code);
    EXPECT_EQ(encode(std::pow((code + 0.51) / 255, 2.2)), code + 1);
    EXPECT_EQ(encode(decode(static_cast<std::uint8_t>(code))), code);
  }
}

TEST(Picture, text_is_drawn_where_it_is_asked_for) {
  Picture picture(40, 20);
  draw_text(picture, 10, 4, 2, "-", {255, 255, 255});
  std::set<int> rows, columns;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (picture.at(x, y) != Color8{}) rows.insert(y), columns.insert(x);
    }
  }
  ASSERT_EQ(rows.size(), 2u);  // one dot of a stroke, at double size
  EXPECT_GE(*rows.begin(), 4);
  EXPECT_LE(*rows.rbegin(), 4 + 2 * 9);
  ASSERT_FALSE(columns.empty());
  EXPECT_GE(*columns.begin(), 10);
  EXPECT_LE(*columns.rbegin(), 10 + text_width(2, "-"));
  draw_text(picture, -7, -3, 3, "cut off at every side", {255, 255, 255});
}

SampleMap ascending_map(int count, int step) {
  SampleMap map{count, 1, {}, count * step};
  for (int i = 1; i <= count; ++i) map.counts.push_back(i * step);
  return map;
}

TEST(SampleMap, goes_from_blue_to_red_and_gets_brighter_all_the_way) {
  const auto y = [](Color8 c) { return luminance({decode(c[0]), decode(c[1]), decode(c[2])}); };
  const Color8 few = sample_color(16, 16, 512), many = sample_color(512, 16, 512);
  EXPECT_GT(few[2], 2 * std::max(few[0], few[1]));
  EXPECT_GT(many[0], 2 * std::max(many[1], many[2]));
  for (int count = 32; count <= 512; count += 16) {
    const Color8 below = sample_color(count - 16, 16, 512), above = sample_color(count, 16, 512);
    EXPECT_GT(above[0], below[0]) << count;
    EXPECT_GT(y(above), y(below)) << count;
  }
  EXPECT_EQ(sample_color(64, 64, 64), many);
}

TEST(SampleMap, picture_shows_the_map_above_a_legend_with_its_limits) {
  const SampleMap map = ascending_map(200, 16);
  const Picture picture = sample_picture(map);
  ASSERT_EQ(picture.width, 200);
  ASSERT_GT(picture.height, 20);
  for (int x = 0; x < 200; ++x) EXPECT_EQ(picture.at(x, 0), sample_color(map.counts[x], 16, 3200));
  // The bar below repeats the range, from its first column to its last.
  const int bar_row = 1 + 6 + 5;
  EXPECT_EQ(picture.at(6, bar_row), sample_color(16, 16, 3200));
  EXPECT_EQ(picture.at(193, bar_row), sample_color(3200, 16, 3200));
  // Another maximum changes the numbers on the right and in the middle.
  SampleMap other = map;
  other.max = 3264;
  const Picture changed = sample_picture(other);
  int differ_left = 0, differ_right = 0;
  for (int y = bar_row + 6; y < picture.height; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (picture.at(x, y) != changed.at(x, y)) ++(x < 60 ? differ_left : differ_right);
    }
  }
  EXPECT_EQ(differ_left, 0);
  EXPECT_GT(differ_right, 0);
}

// The numbers belong to the ends and the middle of the bar: 1608 is halfway between 16 and 3200.
TEST(SampleMap, picture_has_the_numbers_of_its_colours) {
  const SampleMap map = ascending_map(200, 16);
  Picture plain(200, 1);
  for (int x = 0; x < 200; ++x) plain.at(x, 0) = sample_color(map.counts[x], 16, 3200);
  const std::vector<Color8> stops{sample_color(0, 0, 2), sample_color(1, 0, 2),
                                  sample_color(2, 0, 2)};
  const Picture expected = with_legend(plain, stops, {"16", "1608", "3200", "samples per pixel"});
  EXPECT_EQ(sample_picture(map).pixels, expected.pixels);
}

TEST(Picture, each_text_of_a_legend_is_drawn) {
  const std::vector<Color8> stops{{0, 0, 0}, {255, 255, 255}};
  const auto drawn = [&](const Legend& legend) {
    return with_legend(Picture(300, 4), stops, legend).pixels;
  };
  const std::set<std::vector<Color8>> pictures{
      drawn({"a", "b", "c", "d"}), drawn({"X", "b", "c", "d"}), drawn({"a", "X", "c", "d"}),
      drawn({"a", "b", "X", "d"}), drawn({"a", "b", "c", "X"})};
  EXPECT_EQ(pictures.size(), 5u);
}

TEST(SampleMap, picture_is_wide_enough_for_its_legend) {
  EXPECT_GE(sample_picture(ascending_map(2, 10)).width, text_width(1, "samples per pixel"));
  EXPECT_GE(sample_picture(ascending_map(2, 1000000000)).width,
            text_width(1, "1000000000 1500000000 2000000000"));
}

TEST(Compare, has_the_values_worked_out_by_hand) {
  Image a(2, 1), b(2, 1);
  a.at(0, 0) = {1, 0.5, 0};
  b.at(0, 0) = {1, 0.25, 0};
  a.at(1, 0) = {2, 0, 1};
  b.at(1, 0) = {2, 0, 1.5};
  const Comparison c = compare(a, b);
  EXPECT_DOUBLE_EQ(c.mse, (0.0625 + 0.25) / 6);
  const double dark = 0.04 * luminance({1.5, 0.125, 0.75});
  EXPECT_DOUBLE_EQ(c.rel_mse,
                   (0.0625 / std::pow(0.25 + dark, 2) + 0.25 / std::pow(1.5 + dark, 2)) / 6);
  EXPECT_EQ(c.mean_a, (Rgb{1.5, 0.25, 0.5}));
  EXPECT_EQ(c.mean_b, (Rgb{1.5, 0.125, 0.75}));
  EXPECT_EQ(c.largest.x, 1);
  EXPECT_EQ(c.largest.y, 0);
  EXPECT_EQ(c.largest.channel, 2);
  EXPECT_EQ(c.largest.a, 1);
  EXPECT_EQ(c.largest.b, 1.5);
  EXPECT_EQ(c.not_finite, 0u);
}

TEST(Compare, has_the_same_relative_error_for_dimmed_pictures) {
  Image a(2, 1), b(2, 1), dim_a(2, 1), dim_b(2, 1);
  for (int x = 0; x < 2; ++x) {
    a.at(x, 0) = {0.5, 0.1 * x, 1};
    b.at(x, 0) = {0.4, 0.2, 0.001};
    dim_a.at(x, 0) = 0.1 * a.at(x, 0);
    dim_b.at(x, 0) = 0.1 * b.at(x, 0);
  }
  EXPECT_NEAR(compare(dim_a, dim_b).rel_mse, compare(a, b).rel_mse, 1e-9 * compare(a, b).rel_mse);
  EXPECT_EQ(compare(Image(2, 1), Image(2, 1)).rel_mse, 0) << "both are black";
}

TEST(Compare, errors_of_pixels_are_the_roots_in_order) {
  std::vector<double> squares;
  for (int i = 100; i >= 1; --i) squares.push_back(i * i);
  const PixelErrors errors = pixel_errors(squares);
  EXPECT_EQ(errors.median, 50);
  EXPECT_EQ(errors.most, 99);
  EXPECT_EQ(errors.largest, 100);
}

TEST(Compare, leaves_out_what_is_not_finite_and_says_so) {
  Image a(3, 1), b(3, 1);
  a.at(0, 0) = {kNan, 0, 0};
  b.at(1, 0) = {0, 0, kInf};
  a.at(2, 0) = {1, 1, 1};
  const Comparison c = compare(a, b);
  EXPECT_EQ(c.not_finite, 2u);
  EXPECT_EQ(c.mse, 1);
  EXPECT_EQ(c.largest.x, 2);
  EXPECT_EQ(difference_picture(a, b).at(0, 0), (Color8{0, 0, 0}));
}

TEST(Compare, counts_rows_from_the_top) {
  Image a(2, 3), b(2, 3);
  a.at(1, 2) = {0, 0.5, 0};
  EXPECT_EQ(compare(a, b).largest.x, 1);
  EXPECT_EQ(compare(a, b).largest.y, 2);
}

TEST(Compare, needs_equal_sizes) {
  EXPECT_THROW(compare(Image(2, 3), Image(3, 2)), Error);
  EXPECT_THROW(difference_picture(Image(2, 3), Image(2, 4)), Error);
}

TEST(Compare, draws_less_in_blue_and_more_in_orange) {
  EXPECT_EQ(difference_color(0), (Color8{255, 255, 255}));
  for (const double off : {0.02, 0.1, 0.2, 5.0}) {
    const Color8 less = difference_color(-off), more = difference_color(off);
    EXPECT_GT(less[2], less[1]);
    EXPECT_GT(less[1], less[0]);
    EXPECT_GT(more[0], more[1]);
    EXPECT_GT(more[1], more[2]);
  }
  EXPECT_EQ(difference_color(0.2), difference_color(1));
  EXPECT_NE(difference_color(0.2), difference_color(0.19));
  Image a(1, 1), b(1, 1);
  // 0.896 against 1: 0.104 / 1.04 = 10 % less, and so under lamps a hundredth as bright.
  for (const double lamp : {1.0, 0.01}) {
    a.at(0, 0) = gray(0.896 * lamp);
    b.at(0, 0) = gray(lamp);
    EXPECT_EQ(difference_picture(a, b).at(0, 0), difference_color(-0.1));
  }
  EXPECT_EQ(difference_picture(Image(1, 1), Image(1, 1)).at(0, 0), difference_color(0));
}

}  // namespace
}  // namespace pt
