// Radiances of one pixel, and answers that follow from them or do not.
#include "grader/explain/explain.h"

#include <gtest/gtest.h>

namespace grader::explain {
namespace {

using pt::gray;
using pt::Rgb;

TEST(explain_pixel, the_mean_of_all_radiances) {
  const std::vector<Rgb> seen{{1, 2, 3}, {3, 2, 1}, {2, 2, 2}, {6, 6, 6}};
  EXPECT_EQ(explain_pixel(4, gray(3), seen).fault, Fault::none);
  EXPECT_EQ(explain_pixel(4, {3, 3, 3.001}, seen).promise, "averages_the_radiance");
  EXPECT_EQ(explain_pixel(5, gray(3), seen).got, "4 calls of radiance() for 5 samples");
  EXPECT_EQ(explain_pixel(5, gray(3), seen).promise, "takes_the_samples_asked_for");
}

// The first six values vary; then the interval becomes narrow.
std::vector<Rgb> steady_after_six(int n) {
  std::vector<Rgb> seen;
  for (int i = 0; i < n; ++i) seen.push_back(gray(i < 6 ? 1 + 0.2 * (i % 2) : 1.1));
  return seen;
}

// The answer after n of the samples.
Explanation after(int n, int batch, double tolerance, int most = 1000, int said = 0) {
  const std::vector<Rgb> seen = steady_after_six(n);
  Rgb mean;
  for (const Rgb& one : seen) mean += one / n;
  return explain_adaptive({most, batch, tolerance}, {mean, said == 0 ? n : said}, seen);
}

// sigma is .1 sqrt(6 / n), divided by n, so 1.96 sigma / sqrt(n) is .48 / n: .04 after 12 samples and .03 after 16.
TEST(explain_adaptive, the_first_batch_that_is_narrow_enough) {
  const double tolerance = 0.033 / 1.1;
  EXPECT_EQ(after(16, 4, tolerance).fault, Fault::none);
  EXPECT_EQ(after(12, 4, tolerance).promise, "stops_where_the_interval_is_narrow");
  EXPECT_EQ(after(20, 4, tolerance).got, "20 samples");
  EXPECT_EQ(after(20, 4, tolerance).promise, "stops_where_the_interval_is_narrow");
}

TEST(explain_adaptive, counts) {
  const double tolerance = 0.033 / 1.1;
  EXPECT_EQ(after(11, 4, tolerance).promise, "checks_once_a_batch");
  EXPECT_EQ(after(11, 4, tolerance, 11).fault, Fault::none);
  EXPECT_EQ(after(16, 4, tolerance, 1000, 20).promise, "never_exceeds_the_maximum");
  EXPECT_EQ(after(12, 4, tolerance, 11).promise, "never_exceeds_the_maximum");
  EXPECT_EQ(explain_adaptive({8, 4, 1}, {gray(2), 4}, std::vector<Rgb>(4, gray(1))).promise,
            "returns_the_mean_of_all_samples");
}

}  // namespace
}  // namespace grader::explain
