// The most informative failure comes first and is short enough to be read.
#include "grader/report/autograders.h"
#include "grader/report/html.h"
#include "grader/report/junit.h"
#include "grader/report/terminal.h"
#include "grader/results/order.h"
#include "grader/results/readable.h"
#include "grader/results/summary.h"
#include "tests/grader/report/example_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Failure failure(Cause cause, const std::string& got = "2", int cases_before = 0,
                std::size_t lines = 1) {
  Failure out;
  out.input.assign(lines, "a line");
  out.got = got;
  out.expected = "1";
  out.cause = cause;
  out.cases_before = cases_before;
  return out;
}

PromiseResult broken(const std::string& name, const Failure& failure) {
  return {name, name, false, false, 1, 0, {failure}};
}

TaskResult failing(const std::string& slug, std::vector<PromiseResult> promises) {
  TaskResult task;
  task.slug = slug;
  task.state = State::fail;
  task.promises = std::move(promises);
  return task;
}

std::vector<std::string> order(const TaskResult& task) {
  std::vector<std::string> names;
  for (const PromiseResult* each : by_importance(task)) names.push_back(each->name);
  return names;
}

TEST(order, puts_the_most_telling_promise_first) {
  PromiseResult bonus = broken("bonus", failure(Cause::crash));
  bonus.bonus = true;
  PromiseResult kept = broken("kept", {});
  kept.held = true;
  PromiseResult mean = broken("mean", failure(Cause::wrong));
  mean.failures[0].statistical = true;
  const TaskResult task = failing(
      "hit_bvh",
      {bonus, broken("silent", failure(Cause::not_called)),
       broken("long", failure(Cause::wrong, "2", 0, 40)), mean,
       broken("rare", failure(Cause::wrong, "2", 90)), broken("basic", failure(Cause::wrong)), kept,
       broken("special", failure(Cause::wrong)), broken("slow", failure(Cause::timeout)),
       broken("odd", failure(Cause::bad_reply)),
       broken("dead", failure(Cause::crash, "signal 11", 50, 40)), kept, kept, kept});
  EXPECT_THAT(order(task), ElementsAre("dead", "slow", "odd", "basic", "special", "long", "rare",
                                       "mean", "silent", "bonus"));
}

// The task is wrong where a known mistake is that breaks this promise; it only touches the others.
TEST(order, begins_with_the_promise_of_the_most_alike_known_mistake) {
  PromiseResult exact = broken("exact", failure(Cause::wrong)), alike = exact, dead = exact;
  exact.likeness = 0.3;
  alike.name = "alike";
  alike.failures[0].statistical = true;
  alike.likeness = 0.6;
  dead.name = "dead";
  dead.failures[0].cause = Cause::crash;
  EXPECT_THAT(order(failing("a", {exact, alike, dead, dead})),
              ElementsAre("dead", "dead", "alike", "exact"));
}

TEST(order, begins_with_what_is_not_a_number_only_where_a_known_mistake_agrees) {
  PromiseResult wrong = broken("wrong", failure(Cause::wrong));
  PromiseResult odd = broken("odd", failure(Cause::bad_reply)), kept = broken("kept", {});
  wrong.likeness = 0.85;
  kept.held = true;
  odd.likeness = 0.8;
  EXPECT_THAT(order(failing("a", {wrong, odd, kept})), ElementsAre("odd", "wrong"));
  odd.likeness = 0.2;
  EXPECT_THAT(order(failing("a", {wrong, odd, kept})), ElementsAre("wrong", "odd"));
}

TEST(order, counts_likeness_in_tenths_where_nearly_everything_is_broken) {
  PromiseResult basic = broken("basic", failure(Cause::wrong));
  PromiseResult special = broken("special", failure(Cause::wrong)), kept = broken("kept", {});
  kept.held = true;
  basic.likeness = 0.51;
  special.likeness = 0.54;
  EXPECT_THAT(order(failing("a", {basic, special})), ElementsAre("basic", "special"));
  EXPECT_THAT(order(failing("a", {basic, special, kept})), ElementsAre("special", "basic"));
}

TEST(order, prefers_a_failure_on_simple_values) {
  PromiseResult any = broken("any", failure(Cause::wrong)), simple = any, kept = any;
  simple.name = "simple";
  simple.failures[0].simple = true;
  kept.held = true;
  EXPECT_THAT(order(failing("a", {any, simple, kept})), ElementsAre("simple", "any"));
}

// A wrong cosine breaks thirteen promises of fourteen. The simplest, the first, tells more than an exact one.
TEST(order, begins_with_the_first_promise_if_nearly_all_are_broken) {
  PromiseResult first = broken("first", failure(Cause::wrong, "2", 90, 40));
  PromiseResult kept = broken("kept", {});
  first.failures[0].statistical = kept.held = true;
  const PromiseResult exact = broken("exact", failure(Cause::wrong));
  EXPECT_THAT(order(failing("a", {first, exact, exact, exact, kept})),
              ElementsAre("first", "exact", "exact", "exact"));
  EXPECT_THAT(order(failing("a", {first, exact, exact, kept})),
              ElementsAre("exact", "exact", "first"));
}

// A promise that fails in several ways is ranked by its most informative failure.
TEST(order, takes_the_best_failure_of_a_promise) {
  PromiseResult both = broken("both", failure(Cause::wrong, "2", 90));
  both.failures.push_back(failure(Cause::crash));
  EXPECT_THAT(order(failing("a", {broken("plain", failure(Cause::wrong)), both})),
              ElementsAre("both", "plain"));
}

TEST(order, of_failures_begins_with_a_short_input_of_simple_values) {
  Failure crash = failure(Cause::crash, "c", 0, 9), simple = failure(Cause::wrong, "s", 0, 2),
          shorter = failure(Cause::wrong, "h", 0, 1), mean = simple, together = simple;
  simple.simple = mean.simple = together.simple = true;
  mean.got = "m";
  mean.statistical = true;
  together.got = "t";
  together.integrated = true;
  std::vector<Failure> all{together, shorter, mean, simple, failure(Cause::wrong, "l", 0, 8),
                           crash};
  put_most_telling_first(all);
  std::string got;
  for (const Failure& each : all) got += each.got;
  EXPECT_EQ(got, "csmhlt");
}

// Without shadows, few checks of the promise about the sum of lights fail, but nearly all of that about shadows.
TEST(order, a_promise_that_is_broken_in_few_ways_comes_later) {
  PromiseResult few = broken("few", failure(Cause::wrong)), half = few, most = few;
  few.failures.back().input.clear();
  few.checks = 3;
  half.name = "half";
  half.checks = 2;
  half.failures.back().input.clear();
  most.name = "most";
  most.checks = 3;
  most.failures.resize(2, most.failures[0]);
  PromiseResult only = most;
  only.name = "only";
  only.checks = 1;
  PromiseResult together = few;
  together.name = "together";
  together.failures.resize(2, together.failures[0]);
  together.failures[1].integrated = true;
  PromiseResult kept = broken("kept", {});
  kept.held = true;
  EXPECT_THAT(order(failing("a", {few, together, half, most, only, kept, kept})),
              ElementsAre("most", "only", "few", "together", "half"));
}

TEST(order, puts_the_most_telling_task_first) {
  Results results;
  TaskResult picture = failing("picture", {});
  picture.pictures.emplace_back().state = State::fail;
  TaskResult named = failing("named", {broken("a", failure(Cause::wrong))});
  named.mistake = {"epsilon", "It is an epsilon.", "battery", "", false};
  TaskResult unbuilt = failing("unbuilt", {broken("a", {})});
  unbuilt.promises[0].failures.clear();
  unbuilt.compiler_output = "error";
  TaskResult passing = failing("passing", {});
  passing.state = State::pass;
  results.tasks = {
      passing,
      picture,
      failing("wrong", {broken("a", failure(Cause::wrong))}),
      failing("slow", {broken("a", failure(Cause::timeout))}),
      unbuilt,
      failing("dead", {broken("a", failure(Cause::wrong)), broken("b", failure(Cause::crash))}),
      named};
  std::vector<std::string> slugs;
  for (const TaskResult* task : by_importance(results)) slugs.push_back(task->slug);
  EXPECT_THAT(slugs,
              ElementsAre("named", "dead", "unbuilt", "slow", "wrong", "picture", "passing"));
  EXPECT_THAT(report::to_text(results, {}),
              HasSubstr("named: This is a known mistake: It is an epsilon."));
}

class Named : public ExampleRun {
 protected:
  Results named() const {
    Results results = run;
    results.tasks[1].mistake = {"t_min_taken_as_zero", "It compares t with 0 & not t_min.",
                                "battery", "", false};
    results.tasks[1].spared = 0;
    return results;
  }
};

TEST_F(Named, a_mistake_stands_first_in_every_report) {
  const Results results = named();
  const std::string sentence = "This is a known mistake: It compares t with 0 & not t_min.";
  const std::string text = report::to_text(results, {false, true});
  EXPECT_LT(text.find(sentence), text.find("expected  "));
  EXPECT_THAT(report::to_gradescope(results), HasSubstr(sentence));
  const std::string escaped = "This is a known mistake: It compares t with 0 &amp; not t_min.";
  EXPECT_THAT(report::to_junit(results), HasSubstr(escaped));
  const std::string page = report::to_html(results);
  EXPECT_THAT(page,
              HasSubstr("This is a known mistake</span> <strong>It compares t with 0 &amp; not "
                        "t_min.</strong>"));
  EXPECT_THAT(report::to_html(run), Not(HasSubstr("known mistake")));
}

TEST_F(Named, the_hint_stands_behind_the_mistake) {
  Results results = named();
  results.tasks[1].mistake.hint = "Compare t with t_min.";
  const std::string sentence = "compares t with 0 & not t_min. Hint: Compare t with t_min.";
  EXPECT_THAT(results::mistake_text(results.tasks[1]), HasSubstr(sentence));
  const std::string escaped = "not t_min. Hint: Compare t with t_min.";
  EXPECT_THAT(report::to_html(results), HasSubstr("<p>Hint: Compare t with t_min.</p>"));
  EXPECT_THAT(report::to_junit(results), HasSubstr(escaped));
}

TEST_F(Named, what_one_cause_costs_is_said) {
  Results results = named();
  TaskResult& task = results.tasks[1];
  for (PromiseResult& promise : task.promises) promise.held = false;
  int worth = 0;
  for (const PromiseResult& promise : task.promises) worth += promise.bonus ? 0 : promise.points;
  task.spared = worth - 1;
  const std::string expected = "fail, 1 point is taken.";
  EXPECT_THAT(report::to_text(results, {false, true}), HasSubstr(expected));
  EXPECT_THAT(report::to_html(results), HasSubstr(expected));
  EXPECT_THAT(report::to_gradescope(results), HasSubstr(expected));
}

// Three promises of two points each fail, and four of these points are given back.
TEST(Spared, a_bonus_is_no_part_of_what_one_cause_costs) {
  TaskResult task = failing("hit_box", {broken("a", {}), broken("b", {}), broken("c", {}),
                                        broken("extra", {}), broken("kept", {})});
  for (PromiseResult& promise : task.promises) promise.points = 2;
  task.promises[3].bonus = true;
  task.promises[4].held = true;
  task.spared = 4;
  EXPECT_EQ(spared_text(task), "One reason counts once: 3 promises fail, 2 points are taken.");
  task.mistake.name = "epsilon";
  EXPECT_EQ(spared_text(task), "One cause: 3 promises fail, 2 points are taken.");
}

TEST(readable, numbers_have_six_digits) {
  EXPECT_EQ(with_few_digits("(0.1234567891, -2.5, 1e-09)"), "(0.123457, -2.5, 1e-09)");
  EXPECT_EQ(with_few_digits("123456789.25"), "123456789");
  EXPECT_EQ(with_few_digits("seed 12345678901234567890"), "seed 12345678901234567890");
  EXPECT_EQ(with_few_digits("node_1.2345678, v1.2345678"), "node_1.2345678, v1.2345678");
  EXPECT_EQ(with_few_digits("1.23456789e-05 and 3.3333333333 m"), "1.23457e-05 and 3.33333 m");
  EXPECT_EQ(with_few_digits(""), "");
}

TEST(readable, a_number_next_to_a_simple_one_keeps_its_digits) {
  EXPECT_EQ(with_few_digits("0.9999999999"), "0.9999999999");
  EXPECT_EQ(with_few_digits("0.30000000004"), "0.30000000004");
  EXPECT_EQ(with_few_digits("1.0000001e-06"), "1.0000001e-06");
}

TEST(readable, a_difference_keeps_the_digits_that_show_it) {
  Failure report;
  report.got = "0.123456789012345";
  report.expected = "0.123456789512345, give or take 1e-12";
  Failure shown = readable(report).failure;
  EXPECT_EQ(shown.got, "0.123456789");
  EXPECT_EQ(shown.expected, "0.1234567895, give or take 1e-12");
  report.expected = "0.987654321987, give or take 1e-12";
  shown = readable(report).failure;
  EXPECT_EQ(shown.got, "0.123457");
  EXPECT_EQ(shown.expected, "0.987654, give or take 1e-12");
}

TEST(readable, long_inputs_are_folded) {
  Failure report;
  for (int i = 0; i < 172; ++i) report.input.push_back("box " + std::to_string(i));
  const Readable shown = readable(report);
  ASSERT_EQ(shown.failure.input.size(), 10U);
  EXPECT_EQ(shown.failure.input[9], "box 9");
  EXPECT_EQ(shown.lines_left_out, 162U);
  EXPECT_EQ(more_lines(162), "and 162 more lines; --json writes them all");
  report.input.resize(12);
  EXPECT_EQ(readable(report).failure.input, report.input);
  EXPECT_TRUE(readable(report).left_out.empty());
  EXPECT_EQ(readable(report).lines_left_out, 0U);
}

TEST(readable, what_is_folded_is_there) {
  Failure report;
  for (int i = 0; i < 172; ++i) report.input.push_back("box " + std::to_string(i) + ".123456789");
  const std::vector<std::string> rest = readable(report).left_out;
  ASSERT_EQ(rest.size(), 162U);
  EXPECT_EQ(rest.front(), "box 10.1235");
  EXPECT_EQ(rest.back(), "box 171.123");
  report.input.resize(5000);
  EXPECT_EQ(readable(report).left_out.size(), 401U);
  EXPECT_EQ(readable(report).left_out.back(), "and 4590 more lines; --json writes them all");
  EXPECT_EQ(readable(report).lines_left_out, 4990U);
}

}  // namespace
}  // namespace grader::results
