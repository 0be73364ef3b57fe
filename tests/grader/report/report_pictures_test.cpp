// The pictures on a page, and the numbers inside them.
#include "grader/report/embedded.h"
#include "grader/report/pictures.h"
#include "pt/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace grader::report {
namespace {

TEST(embedded, base64_has_the_vectors_of_its_standard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

double from_half(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double size =
      exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return bits & 0x8000 ? -size : size;
}

TEST(embedded, every_half_is_its_own) {
  for (int bits = 0; bits < 0x10000; ++bits) {
    const auto half = static_cast<std::uint16_t>(bits);
    if ((bits >> 10 & 31) == 31) continue;  // infinite or not a number
    ASSERT_EQ(to_half(from_half(half)), half);
  }
}

TEST(embedded, what_is_no_half_becomes_the_nearest) {
  for (const double value : {1e-9, 3e-8, 1e-5, 6.1e-5, 0.1, 0.99999, 1.0 / 3, 2047.6, 65519.0}) {
    const std::uint16_t half = to_half(value);
    const double error = std::abs(from_half(half) - value);
    for (const int other : {std::max(half - 1, 0), std::min(half + 1, 0x7bff)}) {
      EXPECT_LE(error, std::abs(from_half(static_cast<std::uint16_t>(other)) - value)) << value;
    }
    EXPECT_EQ(to_half(-value), half | 0x8000);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {65520.0, 65600.0, 1e300, infinity}) EXPECT_EQ(to_half(value), 0x7c00);
  EXPECT_EQ(to_half(-infinity), 0xfc00);
  EXPECT_GT(to_half(std::nan("")) & 0x7fff, 0x7c00);
}

TEST(embedded, films_are_halves_row_by_row) {
  pt::Film film(2, 1);
  film.set(0, 0, {{1, 2, -0.5}, {}, 0, 0});
  film.set(1, 0, {{0, 0.25, 65504}, {}, 0, 0});
  EXPECT_EQ(embedded_pixels(film),
            base64(std::string("\x00\x3c\x00\x40\x00\xb8\x00\x00\x00\x34\xff\x7b", 12)));
  EXPECT_EQ(embedded_noise(film, film), "");
}

TEST(embedded, noise_is_that_of_the_difference) {
  pt::Film a(1, 1), b(1, 1);
  a.set(0, 0, {{}, {}, 4, 16});   // 1/4
  b.set(0, 0, {{}, {}, 12, 16});  // 3/4
  EXPECT_EQ(embedded_noise(a, b), base64(std::string("\x00\x3c", 2)));
}

TEST(embedded, counts_are_integers) {
  EXPECT_EQ(embedded_counts({2, 1, {258, 1 << 20}, 0}),
            base64(std::string("\x02\x01\x00\x00\x00\x00\x10\x00", 8)));
}

TEST(pictures, blocks_are_means_and_what_is_left_at_the_edges) {
  pt::Image image(11, 9);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 11; ++x) image.at(x, y) = {1.0 * x, 1.0 * y, 1};
  }
  const pt::Image means = block_means(image);
  EXPECT_EQ(means.at(0, 0).r, 3.5);
  EXPECT_EQ(means.at(7, 7).g, 3.5);
  EXPECT_EQ(means.at(8, 0).r, 9);
  EXPECT_EQ(means.at(10, 8).g, 8);
  EXPECT_EQ(means.at(10, 8).b, 1);
}

TEST(pictures, a_block_that_is_a_tenth_too_dark_is_as_blue_as_can_be) {
  pt::Image golden(16, 8), render(16, 8);
  for (pt::Rgb& pixel : golden.pixels) pixel = {1, 1, 1};
  render.pixels = golden.pixels;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) render.at(x, y) = (x % 2 == 0 ? 0.5 : 1.2) * pt::Rgb{1, 1, 1};
  }
  const pt::Picture map = block_difference_map(render, golden);
  EXPECT_EQ(map.at(3, 3), pt::difference_color(-1));
  EXPECT_EQ(map.at(12, 3), (pt::Color8{255, 255, 255}));
}

TEST(pictures, exposure_is_one_unless_nothing_could_be_seen) {
  pt::Image golden(10, 10);
  const auto exposure = [&](double value) {
    for (pt::Rgb& pixel : golden.pixels) pixel = {value, value, value};
    return exposure_for(golden);
  };
  EXPECT_EQ(exposure(0.2), 1);
  EXPECT_EQ(exposure(4), 1);
  EXPECT_EQ(exposure(0), 1);
  EXPECT_EQ(exposure(std::nan("")), 1);
  EXPECT_EQ(exposure(1.0 / 64), 64);
  EXPECT_EQ(exposure(32), 1.0 / 32);
}

// The few bright samples of a path tracer do not make the rest of the picture black.
TEST(pictures, exposure_is_not_that_of_the_brightest_pixel) {
  pt::Image golden(20, 10);
  for (pt::Rgb& pixel : golden.pixels) pixel = pt::gray(1.0 / 64);
  golden.at(7, 3) = pt::gray(1000);
  EXPECT_EQ(exposure_for(golden), 64);
}

// Rec. 709 luma, as a grey printer would show it.
double grey(pt::Color8 c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

TEST(pictures, evidence_reads_in_grey) {
  for (int i = 0; i < 100; ++i) {
    EXPECT_GT(grey(evidence_color(0.02 * i)), grey(evidence_color(0.02 * (i + 1)))) << i;
  }
  EXPECT_EQ(evidence_color(7), evidence_color(2));
}

TEST(pictures, counts_that_differ_by_a_fifth_have_full_colour) {
  const pt::SampleMap golden{3, 1, {100, 100, 100}, 100}, map{3, 1, {80, 100, 120}, 120};
  const pt::Picture picture = count_difference_map(map, golden);
  EXPECT_EQ(picture.at(0, 0), pt::difference_color(-1));
  EXPECT_EQ(picture.at(1, 0), (pt::Color8{255, 255, 255}));
  EXPECT_EQ(picture.at(2, 0), pt::difference_color(1));
}

}  // namespace
}  // namespace grader::report
