// Text from outside, as errors and reports show it.
#include "pt/printable.h"

#include "grader/base/printable.h"
#include "pt/end_of_program.h"
#include "pt/error.h"

#include <string>

#include <gtest/gtest.h>

namespace pt {
namespace {

TEST(Printable, leaves_plain_text_alone) {
  const std::string text = "a c \u00e9 \u2713 \U0001f600 \U0010ffff \ud7ff\ue000 <&\"'";
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable("a\tb\nc", true), "a\tb\nc");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, has_no_controls) {
  EXPECT_EQ(printable("a\x1b[31m\tb\nc\x7f"), "a [31m b c ");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a b");
  EXPECT_EQ(printable("\u0080\u009b[2J\u009f\u00a0"), "  [2J \u00a0");
  EXPECT_EQ(printable("a\x1b[31m\n", true, "?"), "a?[31m\n");
}

TEST(Printable, turns_no_direction_of_writing) {
  EXPECT_EQ(printable("\u202Eab\u2069\u202a\u2066"), "\uFFFDab\uFFFD\uFFFD\uFFFD");
}

// Two names that would look the same, or a name that would end the line.
TEST(Printable, shows_what_is_not_seen) {
  EXPECT_EQ(printable("a\u200bb\ufeff\U000e0041"), "a\uFFFDb\uFFFD\uFFFD");
  EXPECT_EQ(printable("\u2028\u2029\u2060\u206f\u200e\u061c"),
            "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(printable("\u200c\u200d\u202f\u2070\u2027"), "\u200c\u200d\u202f\u2070\u2027");
}

// Each byte that is not part of a character becomes one mark.
TEST(Printable, is_valid_utf8) {
  const std::string mark = "\uFFFD";
  EXPECT_EQ(printable("caf\xe9 \xff\xfe"), "caf" + mark + " " + mark + mark);
  EXPECT_EQ(printable("\xc0\xaf"), mark + mark);             // too long for '/'
  EXPECT_EQ(printable("\xe0\x80\xaf"), mark + mark + mark);  // the same in three bytes
  EXPECT_EQ(printable("\xed\xa0\x80"), mark + mark + mark);  // half a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80").size(), 4 * 3u);   // beyond all characters
  EXPECT_EQ(printable("\xe2\x9c"), mark + mark);             // the end is missing
  EXPECT_EQ(printable("\xe2\x9c"
                      "a"),
            mark + mark + "a");
  EXPECT_EQ(printable("\x80\xbf"), mark + mark);
}

TEST(Printable, is_not_cut_in_a_character) {
  const std::string text = "\u2713\u2713\u2713";
  for (std::size_t most = 0; most < text.size(); ++most) {
    EXPECT_EQ(beginning(text, most), text.substr(0, most / 3 * 3));
    EXPECT_EQ(grader::base::printable(text, most), text.substr(0, most / 3 * 3) + " ...");
  }
  EXPECT_EQ(grader::base::printable(text, text.size()), text);
  EXPECT_EQ(beginning(std::string(9, '\x80'), 5).size(), 2u);
}

TEST(Printable, is_every_error) {
  EXPECT_EQ(sentence_of(Error("'a\u202Eb\xff\n' is missing")), "'a\uFFFDb\uFFFD ' is missing");
}

}  // namespace
}  // namespace pt
