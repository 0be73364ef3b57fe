// Texts that a terminal shows whole.
#include "grader/watch/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::watch {
namespace {

using testing::HasSubstr;

TEST(fit, leaves_alone_what_fits) {
  EXPECT_EQ(fit("one\n\n  two  three\n", {20, 5}), "one\n\n  two  three\n");
  EXPECT_EQ(fit("12345678901234567890", {20, 5}), "12345678901234567890\n");
}

TEST(fit, breaks_lines_between_words) {
  EXPECT_EQ(fit("every word of this is short", {20, 5}), "every word of this \nis short\n");
  EXPECT_EQ(fit("123456789012345678901234567890", {20, 5}), "12345678901234567890\n1234567890\n");
}

TEST(fit, puts_the_rest_below_the_value) {
  EXPECT_EQ(fit("  input     Triangle (0, 0, 0) (1, 0, 0) (0.5, 1, 0)", {41, 5}),
            "  input     Triangle (0, 0, 0) (1, 0, 0) \n            (0.5, 1, 0)\n");
}

TEST(fit, counts_what_is_seen) {
  // 20 characters of two bytes each, and colours, which take no space.
  std::string text = "\x1b[1m";
  for (int i = 0; i < 20; ++i) text += "\u00e9";
  text += "\x1b[0m";
  EXPECT_EQ(fit(text, {20, 5}), text + "\n");
  EXPECT_EQ(fit(text + "x", {20, 5}), text + "\nx\n");
}

TEST(fit, counts_broken_lines_as_rows) {
  const std::string text = fit("a b c d e f g h i j k l m n o p\nsecond\nthird\nfourth\n", {20, 4});
  EXPECT_THAT(text, HasSubstr("second\n  ... 2 more lines"));
}

}  // namespace
}  // namespace grader::watch
