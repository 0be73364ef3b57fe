// The texts of the write-up: figures and numbers in Markdown, and the message on a wrong name.
#include "pt/error.h"
#include "writeup/markdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace writeup {
namespace {

using testing::HasSubstr;

// A text with a figure `box` and a number `box.seconds`.
const Names kNames{
    [](const std::string& name) { return name == "box" ? "<figure>$1</figure>" : ""; },
    [](const std::string& name) { return name == "box.seconds" ? "4.2" : ""; }};

std::string problem_of(const std::string& text) {
  try {
    page_from_text("part1.md", text, kNames);
  } catch (const pt::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Texts, numbers_stand_where_their_names_were) {
  const std::string page = page_from_text("", "Of {{box.seconds}} and {{ box.seconds }}.", kNames);
  EXPECT_EQ(page, "<p>Of 4.2 and 4.2.</p>\n");
}

TEST(Texts, a_figure_stands_between_paragraphs) {
  const std::string page = page_from_text("", "Before\n{{figure box}}\nafter *all*\n", kNames);
  EXPECT_THAT(page, HasSubstr("<p>Before</p>\n<figure>$1</figure>\n<p>after <em>all</em></p>"));
}

TEST(Texts, a_wrong_name_is_told_with_its_line) {
  EXPECT_EQ(problem_of("one\ntwo\n\n{{figure sphere}}\n"),
            "part1.md:4: there is no figure 'sphere'");
  EXPECT_EQ(problem_of("one\n{{box.hours}}\n"), "part1.md:2: there is no number 'box.hours'");
  EXPECT_EQ(problem_of("```\n{{figure box}}\n```\n"),
            "part1.md: a figure stands inside a paragraph");
}

TEST(Texts, code_of_html_is_shown_and_not_followed) {
  EXPECT_EQ(html_from_markdown("a <b>bold</b> word"), "<p>a &lt;b&gt;bold&lt;/b&gt; word</p>\n");
  EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
}

}  // namespace
}  // namespace writeup
