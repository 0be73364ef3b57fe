// The shape of a file, and the groups of submissions that are alike.
#include "grader/service/platforms/likeness.h"

#include "grader/service/platforms/shape.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::platforms {
namespace {

using results::State;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kSource = R"cpp(
#include "pt/tasks/hit_box.h"
  namespace pt {
  namespace {
  // The distance.
  struct Slab {
    double enter, leave;
    int axis = 0;
  };
  double along(const Vec3& a, const Ray& ray) { return dot(a, ray.direction) * 2'000.5e-3; }
  std::optional<Interval> crossing(double t) {
    return t > std::max(0.0, t) ? Interval{t, 1} : Interval{};
  }
  }  // namespace
  std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
    const auto [near, far] = std::pair(along(box.min, ray), along(box.max, ray));
    Slab slab{near, far};
    const Slab* first = &slab;
    double a = 1, b = 2;
    for (int i = 0; i < 3; ++i) a += slab.enter * b + first->leave - slab.axis;
    const std::string text = R"x(a // b)x";
    return crossing(a);
  }
  }  // namespace pt
)cpp";

std::string with(std::string text, const std::vector<std::pair<std::string, std::string>>& edits) {
  for (const auto& [from, to] : edits) {
    EXPECT_NE(text.find(from), text.npos) << from;
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
  }
  return text;
}

TEST(Shape, ignores_comments_layout_and_own_names) {
  const std::string shape = shape_of(kSource).text;
  const std::vector<std::vector<std::pair<std::string, std::string>>> same{
      {{"// The distance.\n", ""}, {"\n  ", "\n\n\t"}},
      {{" * ", "*/* by */"}, {"{near, far}", "{ near ,\\\nfar }"}},
      {{"slab", "s"}, {"first", "pointer"}, {"text", "words"}, {"near", "n"}, {"far", "f"}},
      {{"Slab", "Part"}, {"enter", "lo"}, {"leave", "hi"}, {"axis", "k"}},
      {{"along", "project"},
       {"crossing", "cut"},
       {"int i = 0; i < 3; ++i", "int k = 0; k < 3; ++k"}},
      {{"const Box& box", "const Box& bounds"}, {"box.m", "bounds.m"}},
      {{"double a = 1, b = 2", "double a = 1, c = 2"}, {" * b +", " * c +"}}};
  for (const auto& edits : same) EXPECT_EQ(shape_of(with(kSource, edits)).text, shape);
  EXPECT_GT(shape_of(kSource).tokens, 150);
}

TEST(Shape, keeps_whatever_else_is_written) {
  const std::string shape = shape_of(kSource).text;
  const std::vector<std::pair<std::string, std::string>> other{{"dot(", "cross("},
                                                               {"std::max", "std::min"},
                                                               {"double along", "float along"},
                                                               {"2'000.5e-3", "2'000.5e-4"},
                                                               {"> std", "< std"},
                                                               {"box.min", "box.max"},
                                                               {"a // b", "a // c"},
                                                               {"const Vec3& a", "const Rgb& a"},
                                                               {"slab.enter * b", "slab.leave * b"},
                                                               {"= 1, b = 2", "= 2, b = 1"},
                                                               {"+= slab", "-= slab"},
                                                               {"ray.direction", "ray.origin"}};
  for (const auto& edit : other)
    EXPECT_NE(shape_of(with(kSource, {edit})).text, shape) << edit.first;
}

// Whatever the bytes of a file are, it has a shape soon.
TEST(Shape, of_a_hostile_file_takes_no_time) {
  for (const char* piece :
       {"&f(", "auto [a", "R\"(", "/*", "\"", "'", "\\", "a\\\n", "\xff", "{struct x"}) {
    std::string text;
    while (text.size() < (1 << 18)) text += piece;
    EXPECT_LE(shape_of(text).tokens, text.size());
  }
  EXPECT_EQ(shape_of("").tokens, 0);
}

results::Results run_with(State state, const std::string& got, const std::string& mistake = "") {
  results::Results run;
  results::TaskResult task;
  task.slug = "hit_box";
  task.state = state;
  if (!mistake.empty()) task.mistake = {mistake, "Says " + mistake + ".", "battery", "", false};
  results::PromiseResult promise{"first", "the first: promise", false, got.empty(), 1, 0, {}};
  if (!got.empty())
    promise.failures.push_back({{"x = 1"}, "", got, "1", "", {}, {}, {}, {}, {}, {}});
  task.promises.push_back(promise);
  run.tasks.push_back(task);
  run.complete = true;
  return run;
}

TEST(Likeness, shows_the_rarest_first_with_the_share_of_the_class) {
  Likeness page;
  const auto add = [&](const std::string& name, const std::string& text, const std::string& got,
                       const std::string& mistake = "") {
    page.add(name, {{"hit_box", text}}, run_with(State::fail, got, mistake));
  };
  add("eve", "int a = 1;", "7");
  add("cy", "int a = 1; // mine", "7");
  add("dan", "int b = 1;", "7");
  for (const char* name : {"b2", "b1"}) add(name, "int a = 2;", "8", "close");
  add("odd", "int c() { return 3; }", "8", "close");
  add("fay", "int c() { return 4; }", "9", "close");
  add("right", "int d() { return 4; }", "");
  page.add("new", {{"hit_box", "int a = 2;"}}, run_with(State::not_attempted, ""));

  const auto equal = page.equal_files(), shapes = page.equal_shapes(), faults = page.equal_faults();
  ASSERT_EQ(equal.size(), 1);
  EXPECT_THAT(equal[0].names, ElementsAre("b1", "b2"));
  EXPECT_EQ(equal[0].of, 8);
  EXPECT_EQ(equal[0].size, 5);
  ASSERT_EQ(shapes.size(), 2);
  EXPECT_THAT(shapes[0].names, ElementsAre("fay", "right"));
  EXPECT_THAT(shapes[1].names, ElementsAre("cy", "dan", "eve"));
  ASSERT_EQ(faults.size(), 1);
  EXPECT_THAT(faults[0].names, ElementsAre("b1", "b2", "odd"));
  EXPECT_EQ(faults[0].mistaken, 4);

  const std::string html = page.to_html();
  EXPECT_THAT(html, HasSubstr("9 submissions were compared"));
  EXPECT_THAT(html, HasSubstr("2 of 8 (25 %)"));
  EXPECT_THAT(html, HasSubstr("Says close. This was named for 4 of 8."));
  EXPECT_THAT(html, HasSubstr("<a href=\"b1.html\">b1</a>, <a href=\"b2.html\">b2</a>"));
  EXPECT_THAT(html, HasSubstr("This page is not an accusation."));
  EXPECT_LT(html.find("fay.html"), html.find("eve.html"));
  EXPECT_THAT(html, Not(HasSubstr("new.html")));
}

// A promise that is broken only with the other files of a submission says nothing about this file.
TEST(Likeness, leaves_out_faults_of_other_files) {
  Likeness page;
  for (const char* name : {"a", "b"}) {
    results::Results run = run_with(State::fail, "7");
    run.tasks[0].promises[0].failures[0].integrated = true;
    page.add(name, {{"hit_box", std::string("int f() { return ") + name + "; }"}}, run);
  }
  EXPECT_THAT(page.equal_faults(), IsEmpty());
  EXPECT_THAT(page.to_html(), HasSubstr("<p>None.</p>"));
}

TEST(Likeness, names_only_some_of_many) {
  Likeness page;
  for (int i = 10; i < 30; ++i)
    page.add("s<" + std::to_string(i), {{"hit_box", "int a;"}}, run_with(State::pass, ""));
  const std::string html = page.to_html();
  EXPECT_THAT(html, HasSubstr("s&lt;21</a> and 8 more"));
  EXPECT_THAT(html, HasSubstr("20 of 20 (100 %)"));
}

}  // namespace
}  // namespace grader::platforms
