// The changes between two verdicts on a submission, and the page on a class that was graded twice.
#include "grader/results/changes.h"

#include "grader/service/platforms/compare_page.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

PromiseResult promise(const std::string& name, bool held, int points) {
  return {name, name + ": in words", false, held, points, 0, {}};
}

TaskResult task(const std::string& slug, std::vector<PromiseResult> promises) {
  TaskResult result;
  result.slug = slug;
  result.promises = std::move(promises);
  for (const PromiseResult& each : result.promises) result.points += each.held ? each.points : 0;
  return result;
}

Results run(std::vector<TaskResult> tasks) {
  Results results;
  results.tasks = std::move(tasks);
  return results;
}

TEST(changes, name_the_promise_and_what_it_earned) {
  const Results before = run({task("hit_box", {promise("a", true, 2), promise("b", true, 1)})});
  const Results after = run({task("hit_box", {promise("a", false, 2), promise("b", true, 1)})});
  EXPECT_THAT(changes(before, after), ElementsAre(Change{"hit_box", "a: in words", 2, 0}));
  EXPECT_THAT(changes(after, before), ElementsAre(Change{"hit_box", "a: in words", 0, 2}));
  EXPECT_TRUE(changes(before, before).empty());
}

TEST(changes, tell_of_weights_and_of_promises_and_tasks_that_come_and_go) {
  const Results before = run({task("hit_box", {promise("a", true, 2), promise("gone", true, 3)}),
                              task("hit_bvh", {promise("c", true, 4)})});
  const Results after = run({task("hit_box", {promise("a", true, 5), promise("new", true, 1)})});
  EXPECT_THAT(changes(before, after), ElementsAre(Change{"hit_box", "a: in words", 2, 5},
                                                  Change{"hit_box", "new: in words", 0, 1},
                                                  Change{"hit_box", "gone: in words", 3, 0},
                                                  Change{"hit_bvh", "c: in words", 4, 0}));
}

// The differences always add up to the difference in points.
TEST(changes, add_up_to_the_difference_of_the_points) {
  std::mt19937 random(18);
  const auto draw = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto any = [&] {
    TaskResult result = task("hit_box", {});
    for (const char* name : {"a", "b", "c", "d"}) {
      if (draw(4) == 0) continue;
      result.promises.push_back(promise(name, draw(2) == 0, draw(4)));
      result.promises.back().bonus = draw(4) == 0;
      const PromiseResult& last = result.promises.back();
      (last.bonus ? result.bonus_points : result.points) += last.held ? last.points : 0;
    }
    PictureResult picture;
    picture.recipe = "rays";
    picture.points = draw(4);
    result.pictures = {picture};
    result.spared = draw(3);
    result.points += picture.points + result.spared;
    if (draw(3) == 0) result.points = std::max(0, result.points - 3);  // the task keeps state
    return run({result});
  };
  for (int i = 0; i < 2000; ++i) {
    const Results before = any(), after = any();
    int sum = 0;
    for (const Change& change : changes(before, after)) {
      EXPECT_NE(change.before, change.after);
      sum += change.after - change.before;
    }
    const auto points = [](const Results& each) {
      return each.tasks[0].points + each.tasks[0].bonus_points;
    };
    ASSERT_EQ(sum, points(after) - points(before));
  }
}

platforms::Comparison example() {
  platforms::Comparison comparison;
  comparison.former = "old";
  comparison.rows = {{"ada", "ada.html", 10, 12, 8, 12, {{"hit_box", "a <promise>", 2, 0}}},
                     {"bob, jr", "bob.html", 10, 12, 11, 12, {{"hit_bvh", "=b", 0, 1}}},
                     {"eve", "eve.html", 12, 12, 12, 12, {}},
                     {"dan", "dan.html", 9, 12, 7, 12, {{"hit_box", "a <promise>", 2, 0}}}};
  comparison.only_after = {"zoe"};
  return comparison;
}

TEST(comparison, is_told_in_a_sentence_and_a_table) {
  EXPECT_EQ(platforms::comparison_sentence(example()),
            "1 gains points, 2 lose points, 1 has the same.");
  const std::string csv = platforms::comparison_csv(example());
  EXPECT_THAT(csv, HasSubstr("\r\nada,10,12,8,12,hit_box,a <promise>,2,0\r\n"));
  EXPECT_THAT(csv, HasSubstr("\r\n\"bob, jr\",10,12,11,12,hit_bvh,'=b,0,1\r\n"));
  EXPECT_THAT(csv, Not(HasSubstr("eve")));
}

TEST(comparison, has_a_table_whose_columns_stand_below_their_names) {
  platforms::Comparison comparison;
  comparison.rows = {{"ada", "ada.html", 1, 2, 3, 4, {{"hit_box", "a", 5, 6}}}};
  EXPECT_THAT(
      platforms::comparison_csv(comparison),
      testing::EndsWith("submission,points_before,max_before,points,max_points,task,promise,"
                        "promise_before,promise_after\r\nada,1,2,3,4,hit_box,a,5,6\r\n"));
}

// In alphabetical order it would be the last.
TEST(comparison, has_a_page_with_the_cause_of_most_changes_first) {
  platforms::Comparison comparison = example();
  for (platforms::Comparison::Row& row : comparison.rows) {
    for (Change& change : row.changes) change.slug = change.slug == "hit_box" ? "hit_sphere" : "a";
  }
  const std::string page = platforms::comparison_html(comparison);
  const std::size_t two = page.find("<code>hit_sphere</code></td>"),
                    one = page.find("<code>a</code></td>");
  ASSERT_NE(one, page.npos);
  EXPECT_LT(two, one);
}

TEST(comparison, has_a_page_with_who_loses_most_first) {
  const std::string page = platforms::comparison_html(example());
  const std::size_t ada = page.find("ada.html"), bob = page.find("bob.html");
  ASSERT_NE(ada, page.npos);
  EXPECT_LT(ada, bob);
  EXPECT_EQ(page.find("eve.html"), page.npos);
  EXPECT_THAT(page, HasSubstr("a &lt;promise&gt;"));
  EXPECT_THAT(page, HasSubstr("Judged now, and not before: zoe."));
  EXPECT_THAT(page, HasSubstr(">0</td><td class=\"number\">2</td><td class=\"number\">\u22124<"));
}

}  // namespace
}  // namespace grader::results
