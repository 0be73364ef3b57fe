// The texts of the write-up: figures and numbers in Markdown, and the message on a wrong name.
#include "pt/error.h"
#include "pt/file.h"
#include "writeup/markdown.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace writeup {
namespace {

using testing::HasSubstr;
using testing::Not;

using Numbers = std::map<std::string, std::string>;

// A page with these numbers; all others are not measured.
std::string page_with(const std::string& text, const Numbers& numbers) {
  return page_from_text("part.md", text,
                        {[](const std::string&) { return "<figure>"; },
                         [&](const std::string& name) {
                           const auto found = numbers.find(name);
                           return found == numbers.end() ? kDash : found->second;
                         }});
}

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

TEST(Texts, a_sentence_stands_only_where_it_is_true) {
  const std::string text =
      "It has {{a}} and {{b}}.{{if a < b}} So a wins.{{if a < b}} So b wins.{{if a > b}} The end.";
  const std::string a = page_with(text, {{"a", "4.2"}, {"b", "13"}});
  EXPECT_EQ(a, "<p>It has 4.2 and 13. So a wins. The end.</p>\n");
  EXPECT_EQ(page_with(text, {{"a", "13"}, {"b", "4.2"}}), "<p>So b wins. The end.</p>\n");
  EXPECT_EQ(page_with("A.{{if 3*a > b}}", {{"a", "5"}, {"b", "14"}}), "<p>A.</p>\n");
  EXPECT_EQ(page_with("A.{{if a > 0.5}}", {{"a", "0.4"}}), "");
  EXPECT_THROW(page_with("A.{{if a is b}}", {}), pt::Error);
}

TEST(Texts, a_sentence_without_its_number_is_left_out) {
  const std::string page = page_with(
      "**Why.** It takes {{a}} s. That is\nmuch, e.g. 3.5 times. And {{b}} more.\n\n- One "
      "{{b}}.\n- Two\n  of "
      "{{a}}.\n\n| x | y |\n|---|---|\n| {{a}} | {{b}} |\n",
      {{"a", "2"}});
  EXPECT_THAT(page,
              HasSubstr("<strong>Why.</strong> It takes 2 s. That is\nmuch, e.g. 3.5 times."));
  EXPECT_THAT(page, Not(HasSubstr("more.")));
  EXPECT_THAT(page, Not(HasSubstr("One")));
  EXPECT_THAT(page, HasSubstr("of 2."));
  EXPECT_THAT(page, HasSubstr("<td>\u2013</td>"));
  EXPECT_THAT(page, HasSubstr("2 sentences of this text are left out"));
  EXPECT_THAT(page_with("**Why.** It takes {{b}} s.", {}), Not(HasSubstr("It takes")));
}

std::string part(const std::string& name) {
  return pt::read_file(FIRSTLIGHT_ROOT "/writeup/" + name + ".md", 1 << 20);
}

// The pages of the reference, with numbers of other pictures: what was true is not said any more.
TEST(Pages, say_what_their_numbers_say) {
  Numbers lamp{{"components.indirect.lamp", "0.001"}, {"components.indirect.mean", "0.066"}};
  EXPECT_THAT(page_with(part("part4"), lamp), HasSubstr("Here it is nearly black"));
  EXPECT_THAT(page_with(part("part4"), lamp), Not(HasSubstr("Here it is not black")));
  lamp["components.indirect.lamp"] = "0.186";
  EXPECT_THAT(page_with(part("part4"), lamp), HasSubstr("Here it is not black"));
  EXPECT_THAT(page_with(part("part4"), lamp), Not(HasSubstr("Here it is nearly black")));

  Numbers samples{{"sample_rates.s4.samples", "4"},   {"sample_rates.s4.error", "56.1"},
                  {"sample_rates.s16.samples", "16"}, {"sample_rates.s16.error", "28"},
                  {"sample_rates.s64.samples", "64"}, {"sample_rates.s64.error", "14"}};
  EXPECT_THAT(page_with(part("part4"), samples), HasSubstr("falls by half"));
  samples["sample_rates.s16.error"] = "56.1";
  EXPECT_THAT(page_with(part("part4"), samples), Not(HasSubstr("falls by half")));

  Numbers direct{{"direct_spheres.l16.error", "4.2"},
                 {"direct_spheres.h64.error", "13.7"},
                 {"direct_spheres.h64.samples", "64"},
                 {"direct_spheres.h64.seconds", "43.8"}};
  EXPECT_THAT(page_with(part("part3"), direct), HasSubstr("still has 13.7 %"));
  direct["direct_spheres.l16.error"] = "14";
  EXPECT_THAT(page_with(part("part3"), direct), Not(HasSubstr("still has")));

  Numbers pixels{{"adaptive_uniform.adaptive.pixel_largest", "13"},
                 {"adaptive_uniform.uniform.pixel_largest", "46"},
                 {"adaptive_uniform.adaptive.pixel_median", "9"},
                 {"adaptive_uniform.uniform.pixel_median", "5"}};
  EXPECT_THAT(page_with(part("part5"), pixels), HasSubstr("its worst pixel is better"));
  pixels["adaptive_uniform.adaptive.pixel_largest"] = "50";
  EXPECT_THAT(page_with(part("part5"), pixels), Not(HasSubstr("its worst pixel is better")));
}

TEST(Texts, code_of_html_is_shown_and_not_followed) {
  EXPECT_EQ(html_from_markdown("a <b>bold</b> word"), "<p>a &lt;b&gt;bold&lt;/b&gt; word</p>\n");
  EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
}

}  // namespace
}  // namespace writeup
