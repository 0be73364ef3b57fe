// The texts of the write-up: figures and numbers in Markdown, and the message on a wrong name.
#include "pt/error.h"
#include "pt/file.h"
#include "writeup/markdown.h"
#include "writeup/pages.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <vector>

#include <fmt/format.h>
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
  EXPECT_THAT(page_with("**Why.** It takes {{b}} s.", {}), Not(HasSubstr("Why")));
  EXPECT_THAT(page_with("**Why.** It takes {{b}} s. **Remedy.** A.", {}),
              HasSubstr("<p><strong>Remedy.</strong> A.</p>"));
  EXPECT_THAT(page_with("**Why.** A. **Remedy.** It takes {{b}} s.", {}),
              HasSubstr("<p><strong>Why.</strong> A.</p>"));
  EXPECT_THAT(page_with("**It is so.** {{b}} s. A.", {}),
              HasSubstr("<p><strong>It is so.</strong> A.</p>"));
}

// All pages of the reference, in one text.
std::string all_pages() {
  std::string text;
  for (const std::string& name : page_names()) {
    const std::string page = pt::read_file(FIRSTLIGHT_ROOT "/writeup/" + name + ".md", 1 << 20);
    text += std::regex_replace(page, std::regex(R"(\{\{figure [^}]*\}\})"), "") + "\n\n";
  }
  return text;
}

const std::regex kConditions(R"(((?:\{\{if [^}]*\}\})+))");
const std::regex kCondition(R"(\{\{if (?:([0-9.]+)\*)?(\S+) ([<>]) (?:([0-9.]+)\*)?(\S+)\}\})");

std::vector<std::smatch> all_matches(const std::string& text, const std::regex& form) {
  return {std::sregex_iterator(text.begin(), text.end(), form), std::sregex_iterator()};
}

// One side of a condition: a factor, and a number or its name.
double side(const std::string& factor, const std::string& name, const Numbers& numbers) {
  const auto found = numbers.find(name);
  const std::string& value = found == numbers.end() ? name : found->second;
  return (factor.empty() ? 1 : std::stod(factor)) * std::stod(value);
}

bool holds(const std::smatch& condition, const Numbers& numbers) {
  const double a = side(condition[1], condition[2], numbers);
  const double b = side(condition[4], condition[5], numbers);
  return condition[3] == "<" ? a < b : a > b;
}

// A page of which all numbers are 1 but these.
std::string others_are_one(const std::string& text, const Numbers& numbers) {
  return page_from_text("", text,
                        {[](const std::string&) { return "<figure>"; },
                         [&](const std::string& name) {
                           const auto found = numbers.find(name);
                           return found == numbers.end() ? "1" : found->second;
                         }});
}

// Each sentence with conditions, under numbers that are drawn until all of them hold: it stands. With
// one more draw that breaks a condition, or with a number that is not measured, it does not.
TEST(Pages, sentences_that_compare_stand_only_where_they_are_true) {
  const std::string text = all_pages();
  const std::vector<std::smatch> runs = all_matches(text, kConditions);
  EXPECT_GT(runs.size(), 30u);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-4, 4);
  for (const std::smatch& run : runs) {
    // A word before the sentence's end shows whether it stands. Paragraphs depend on nothing beside them.
    const auto at = static_cast<std::size_t>(run.position());
    const std::size_t start = text.rfind("\n\n", at);
    std::string marked = text.substr(start, text.find("\n\n", at) - start);
    marked.insert(marked.find_last_of(".:?", at - start - 1), " MARK");
    const std::string words = run[1];
    const std::vector<std::smatch> conditions = all_matches(words, kCondition);
    Numbers numbers;
    const auto draw = [&] {
      for (const std::smatch& condition : conditions) {
        for (const int name : {2, 5}) {
          if (std::isdigit(condition.str(name)[0]) != 0) continue;
          const double size = std::pow(10, exponent(random)) * (random() % 2 == 0 ? 1 : -1);
          numbers[condition[name]] = fmt::format("{:.9g}", size);
        }
      }
      return std::ranges::all_of(conditions,
                                 [&](const auto& condition) { return holds(condition, numbers); });
    };
    int tries = 0;
    while (!draw()) ASSERT_LT(++tries, 1000000) << words;
    EXPECT_THAT(others_are_one(marked, numbers), HasSubstr("MARK")) << words;
    Numbers unmeasured = numbers;
    unmeasured.begin()->second = kDash;
    EXPECT_THAT(others_are_one(marked, unmeasured), Not(HasSubstr("MARK"))) << words;
    while (draw()) ASSERT_LT(++tries, 1000000) << words;
    EXPECT_THAT(others_are_one(marked, numbers), Not(HasSubstr("MARK"))) << words;
  }
}

// A number that changes is seen on the page; one that was not measured takes its sentence away, or is a
// dash in a table.
TEST(Pages, have_the_numbers_that_were_measured) {
  const std::string text = std::regex_replace(all_pages(), kConditions, "");
  std::set<std::string> names;
  for (const std::smatch& found : all_matches(text, std::regex(R"(\{\{([^}]*)\}\})"))) {
    names.insert(found[1]);
  }
  EXPECT_GT(names.size(), 150u);
  Numbers all, half;
  for (const std::string& name : names) {
    all[name] = fmt::format("7{}.53", 1000 + all.size());
    half[name] = all.size() % 2 == 0 ? all[name] : kDash;
  }
  const std::string said = others_are_one(text, all), less = others_are_one(text, half);
  EXPECT_THAT(said, Not(HasSubstr("left out here")));
  EXPECT_THAT(less, HasSubstr("left out here"));
  for (const auto& [name, number] : all) {
    EXPECT_THAT(said, HasSubstr(number)) << name;
    if (half[name] != kDash) continue;
    EXPECT_THAT(less, Not(HasSubstr(number))) << name;
  }
}

TEST(Texts, formulas_are_elements_and_nothing_else_is) {
  EXPECT_EQ(html_from_markdown("```mathml\n<mi>n</mi><mo>></mo><script>\n```\n"),
            "<p class=\"formula\"><math display=\"block\"><mi>n</mi><mo>&gt;</mo>&lt;script&gt;\n"
            "</math></p>\n");
  EXPECT_THAT(html_from_markdown("```\n<mi>n</mi>\n```\n"), HasSubstr("&lt;mi&gt;"));
}

TEST(Texts, code_of_html_is_shown_and_not_followed) {
  EXPECT_EQ(html_from_markdown("a <b>bold</b> word"), "<p>a &lt;b&gt;bold&lt;/b&gt; word</p>\n");
  EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
}

}  // namespace
}  // namespace writeup
