// The sketch of a file, and the groups of submissions that are alike.
#include "grader/service/platforms/likeness.h"

#include "pt/file.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
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
  std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
    double enter = ray.t_min, leave = ray.t_max;  // of all slabs
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = 1 / ray.direction[axis];
      double near = (box.min[axis] - ray.origin[axis]) * inverse;
      double far = (box.max[axis] - ray.origin[axis]) * inverse;
      if (near > far) std::swap(near, far);
      enter = std::max(enter, near);
      leave = std::min(leave, far);
    }
    if (!(enter <= leave)) return std::nullopt;
    return Interval{enter, leave};
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

using Prints = std::set<std::uint64_t>;

Prints prints_of(const std::string& source) {
  Prints all;
  for (const Print& print : sketch_of(source)) all.insert(print.hash);
  return all;
}

Prints without(const Prints& a, const Prints& b) {
  Prints rest;
  std::ranges::set_difference(a, b, std::inserter(rest, rest.end()));
  return rest;
}

double share_of(const Prints& a, const Prints& b) {
  const std::size_t common = a.size() - without(a, b).size();
  return static_cast<double>(common) /
         static_cast<double>(std::max<std::size_t>(1, std::min(a.size(), b.size())));
}

TEST(Sketch, ignores_comments_layout_names_and_numbers) {
  const Prints prints = prints_of(kSource);
  EXPECT_GT(prints.size(), 15);
  const std::vector<std::vector<std::pair<std::string, std::string>>> same{
      {{"  // of all slabs", ""}, {"\n  ", "\n\n\t"}},
      {{"/ ray", "/*by*/ /\\\n ray"}},
      {{"near", "t0"}, {"far", "t1"}, {"enter", "a"}, {"hit_box", "box_hit"}},
      {{"1 /", "1.0e+0 /"}, {"\n#include \"pt/tasks/hit_box.h\"", "\n#include <cmath>"}}};
  for (const auto& edits : same) EXPECT_EQ(prints_of(with(kSource, edits)), prints);
}

// A window has one print at least, and its hashes depend on its tokens alone.
TEST(Sketch, shares_a_print_where_nineteen_tokens_are_equal) {
  const std::string row = "if ( a < b ) { return c + d * 2 ; } else do";  // 19 tokens
  EXPECT_GT(share_of(prints_of("x = y; " + row + " ++;"), prints_of("for (;;) " + row)), 0);
  EXPECT_EQ(prints_of("int main() { return 0; }").size(), 0);
}

TEST(Sketch, has_the_lines_of_its_prints) {
  const std::vector<Print> prints = sketch_of(kSource);
  ASSERT_FALSE(prints.empty());
  EXPECT_GE(prints.front().first_line, 3);
  EXPECT_LE(prints.back().last_line, 17);
  for (const Print& print : prints) EXPECT_LE(print.first_line, print.last_line);
}

// Whatever the bytes of a file are, its sketch is small.
TEST(Sketch, of_a_hostile_file_is_bounded) {
  for (const char* piece : {"&f(", "R\"(", "/*", "\"", "'", "\\", "a\\\n", "\\\n", "\xff", "//\\\n",
                            "1'", ".", "a b "}) {
    std::string text;
    while (text.size() < (1 << 20)) text += piece;
    EXPECT_LE(sketch_of(text).size(), 1 << 17) << piece;
  }
  EXPECT_TRUE(sketch_of("").empty());
}

// Copies of the right solutions in degrees, beside pairs of right solutions that have few lines in common.
std::string renamed(const std::string& source) {
  static const std::regex name("[A-Za-z_][A-Za-z_0-9]*");
  static const std::set<std::string> kept{"const",  "double", "for",      "if",   "int",
                                          "return", "while",  "auto",     "bool", "else",
                                          "void",   "struct", "namespace"};
  std::map<std::string, std::string> names;
  std::string text;
  auto last = source.cbegin();
  for (std::sregex_iterator at(source.begin(), source.end(), name), end; at != end; ++at) {
    text.append(last, source.cbegin() + at->position());
    const std::string word = at->str();
    if (word.size() > 2 && !kept.contains(word) && !std::isupper(word[0]))
      text += names.try_emplace(word, "q" + std::to_string(names.size())).first->second;
    else
      text += word;
    last = source.cbegin() + at->position() + at->length();
  }
  return text.append(last, source.cend());
}

std::vector<std::string> lines_of(const std::string& source) {
  std::vector<std::string> lines;
  std::istringstream in(source);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool is_statement(const std::string& line) {
  return line.starts_with("  ") && line.ends_with(";") && line.find("return") == line.npos &&
         line.find("using") == line.npos;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string with_inert_statements(const std::string& source) {
  std::vector<std::string> lines;
  int count = 0;
  for (const std::string& line : lines_of(source)) {
    lines.push_back(line);
    if (is_statement(line) && count++ % 6 == 3) lines.emplace_back("  volatile int inert = 0;");
  }
  return joined(lines);
}

std::string with_lines_swapped(const std::string& source) {
  std::vector<std::string> lines = lines_of(source);
  for (std::size_t i = 0, swaps = 0; i + 1 < lines.size() && swaps < 2; ++i) {
    if (!is_statement(lines[i]) || !is_statement(lines[i + 1])) continue;
    std::swap(lines[i], lines[i + 1]);
    i += 4;
    ++swaps;
  }
  return joined(lines);
}

std::string with_other_loops(const std::string& source) {
  static const std::regex loop(R"(for \(([^;()]*);([^;]*);([^)]*)\))"), add(R"((\w+) \+= )");
  return std::regex_replace(std::regex_replace(source, loop, "$1; while ($2)"), add, "$1 = $1 + ");
}

double common_lines(const std::string& a, const std::string& b) {
  std::set<std::string> of_a, of_b, common;
  for (const std::string& line : lines_of(a)) of_a.insert(line);
  for (const std::string& line : lines_of(b)) of_b.insert(line);
  std::ranges::set_intersection(of_a, of_b, std::inserter(common, common.end()));
  return static_cast<double>(common.size()) /
         static_cast<double>(std::max<std::size_t>(1, std::min(of_a.size(), of_b.size())));
}

// The share of pairs (copy, independent) in which the copy is more alike.
double area(const std::vector<double>& copies, const std::vector<double>& independent) {
  double won = 0;
  for (const double copy : copies) {
    for (const double other : independent) won += copy > other ? 1 : copy == other ? 0.5 : 0;
  }
  return won / static_cast<double>(copies.size() * independent.size());
}

// With FIRSTLIGHT_COPIES, the name of a new folder, all files and a list of the pairs go there (bench/against_dolos.mjs).
class Kept {
 public:
  void add(const std::string& kind, const std::string& stub, const std::string& a,
           const std::string& b, double share) {
    if (folder_ == nullptr) return;
    const std::string path = std::string(folder_) + "/" + std::to_string(number_++);
    std::filesystem::create_directories(path);
    pt::write_file(path + "/a.cpp", a);
    pt::write_file(path + "/b.cpp", b);
    pt::write_file(path + "/stub.cpp", pt::read_file(stub));
    list_ += kind + "\t" + path + "\t" + std::to_string(share) + "\n";
    pt::write_file(std::string(folder_) + "/pairs.txt", list_);
  }

 private:
  const char* folder_ = std::getenv("FIRSTLIGHT_COPIES");
  int number_ = 0;
  std::string list_;
};

TEST(Sketch, tells_copies_from_independent_work) {
  namespace fs = std::filesystem;
  const std::string root = FIRSTLIGHT_ROOT;
  using Edit = std::pair<const char*, std::function<std::string(const std::string&)>>;
  const std::vector<Edit> edits{
      {"names and comments", [](const std::string& text) { return text; }},
      {"and inert statements", with_inert_statements},
      {"and two pairs of lines swapped", with_lines_swapped},
      {"and loops rewritten", with_other_loops}};
  Kept kept;
  std::vector<double> independent, related;
  std::vector<std::vector<double>> copies(edits.size());
  for (const auto& part : fs::directory_iterator(root + "/student")) {
    if (!fs::is_directory(part)) continue;
    for (const auto& stub : fs::directory_iterator(part)) {
      const std::string folder = root + "/grader/tasks/" + stub.path().stem().string() + "/right";
      if (!fs::is_directory(folder)) continue;
      std::vector<std::string> texts;
      std::vector<Prints> sketches;
      const Prints handed_out = prints_of(pt::read_file(stub.path()));
      for (const auto& file : fs::directory_iterator(folder)) {
        texts.push_back(pt::read_file(file.path()));
        sketches.push_back(without(prints_of(texts.back()), handed_out));
      }
      for (std::size_t i = 0; i < texts.size(); ++i) {
        for (std::size_t k = 0; k < edits.size(); ++k) {
          const std::string copy = edits[k].second(renamed(texts[i]));
          copies[k].push_back(share_of(sketches[i], without(prints_of(copy), handed_out)));
          kept.add(edits[k].first, stub.path(), texts[i], copy, copies[k].back());
        }
        for (std::size_t j = i + 1; j < texts.size(); ++j) {
          const bool is_related = common_lines(texts[i], texts[j]) > 0.5;
          const double share = share_of(sketches[i], sketches[j]);
          (is_related ? related : independent).push_back(share);
          if (!is_related) kept.add("independent", stub.path(), texts[i], texts[j], share);
        }
      }
    }
  }
  ASSERT_GT(independent.size(), 100);
  const double most = *std::ranges::max_element(independent);
  std::printf("%zu independent pairs, at most %.2f alike; %zu related ones left out\n",
              independent.size(), most, related.size());
  for (std::size_t k = 0; k < edits.size(); ++k) {
    const auto found = std::ranges::count_if(copies[k], [&](double share) { return share > most; });
    const double auc = area(copies[k], independent);
    std::printf("%-32s area %.4f, %td of %zu above every independent pair\n", edits[k].first, auc,
                found, copies[k].size());
    EXPECT_GT(auc, 0.97) << edits[k].first;
  }
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

std::string no_source(const std::string&, const std::string&) { return ""; }

TEST(Likeness, ranks_pairs_and_leaves_out_what_most_have_and_the_stub) {
  const std::string other =
      "bool f(int a) { switch (a) { case 1: return a > 2 ? true : false; default: while (a) a -= "
      "3; "
      "} do { a *= 2; } while (a < 9); return !a; }";
  Likeness page(
      {{"hit_box", {"", {{"reference/2_bvh/hit_box.cpp", kSource}}}}, {"hit_bvh", {kSource, {}}}});
  const auto add = [&](const std::string& name, const std::string& text) {
    results::Results run = run_with(State::pass, "");
    run.tasks.push_back(run.tasks[0]);
    run.tasks[1].slug = "hit_bvh";
    page.add(name, {{"hit_box", text}, {"hit_bvh", text}}, run);
  };
  add("ada", kSource);
  add("bob", with(kSource, {{"near", "t0"}, {"    if (t0", "  volatile int x = 0;\n    if (t0"}}));
  add("cy", other);
  const auto pairs = page.pairs();
  ASSERT_EQ(pairs.size(), 1);  // in hit_bvh it is what was handed out
  EXPECT_EQ(pairs[0].slug + pairs[0].a + pairs[0].b, "hit_boxadabob");
  EXPECT_GT(pairs[0].share, 0.6);
  const auto known = page.known_pairs();
  ASSERT_EQ(known.size(), 2);
  EXPECT_EQ(known[0].a + known[0].b, "adareference/2_bvh/hit_box.cpp");
  EXPECT_EQ(known[0].share, 1);
  const std::string html =
      page.to_html([](const std::string&, const std::string&) { return kSource; });
  EXPECT_THAT(html, HasSubstr("if (near &gt; far) std::swap(near, far);</mark>"));
  add("dan", kSource + "// most have it");
  add("eve", kSource + "// most have it too");
  EXPECT_THAT(page.pairs(), IsEmpty());
}

// Right work that lacks a bonus is not wrong.
TEST(Likeness, calls_only_wrong_files_wrong_in_the_same_way) {
  Likeness page;
  page.add("a", {{"hit_box", "int a;"}}, run_with(State::pass, "7"));
  page.add("b", {{"hit_box", "int b;"}}, run_with(State::pass, "7"));
  EXPECT_THAT(page.equal_faults(), IsEmpty());
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

  const auto equal = page.equal_files(), faults = page.equal_faults();
  ASSERT_EQ(equal.size(), 1);
  EXPECT_THAT(equal[0].names, ElementsAre("b1", "b2"));
  EXPECT_EQ(equal[0].of, 8);
  ASSERT_EQ(faults.size(), 2);
  EXPECT_THAT(faults[0].names, ElementsAre("b1", "b2", "odd"));
  EXPECT_EQ(faults[0].mistaken, 4);
  EXPECT_THAT(faults[1].names, ElementsAre("cy", "dan", "eve"));

  const std::string html = page.to_html(no_source);
  EXPECT_THAT(html, HasSubstr("9 submissions were compared"));
  EXPECT_THAT(html, HasSubstr("2 of 8 (25 %)"));
  EXPECT_THAT(html, HasSubstr("Says close. This was named for 4 of 8."));
  EXPECT_THAT(html, HasSubstr("<a href=\"b1.html\">b1</a>, <a href=\"b2.html\">b2</a>"));
  EXPECT_THAT(html, HasSubstr("This page is not an accusation."));
  EXPECT_LT(html.find("odd.html"), html.find("cy.html"));
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
  EXPECT_THAT(page.to_html(no_source), HasSubstr("<p>None.</p>"));
}

TEST(Likeness, names_only_some_of_many) {
  Likeness page;
  for (int i = 10; i < 30; ++i)
    page.add("s<" + std::to_string(i), {{"hit_box", "int a;"}}, run_with(State::pass, ""));
  const std::string html = page.to_html(no_source);
  EXPECT_THAT(html, HasSubstr("s&lt;21</a> and 8 more"));
  EXPECT_THAT(html, HasSubstr("20 of 20 (100 %)"));
}

}  // namespace
}  // namespace grader::platforms
