// Naming a mistake, on constructed answers with numbers whose errors are known.
#include "grader/mistakes/naming.h"

#include "grader/mistakes/battery.h"
#include "grader/mistakes/known.h"
#include "pt/error.h"
#include "pt/math/uncertain.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace grader::mistakes {
namespace {

Answer exact(std::vector<double> values) { return {"", std::move(values), {}}; }
Answer ended(const std::string& how) { return {how, {}, {}}; }

TEST(answers, that_are_exact_agree_to_a_millionth_of_the_largest) {
  const Answers one{exact({100, 1})};
  EXPECT_TRUE(agree(one, one));
  EXPECT_TRUE(agree(one, {exact({100.00009, 1})}));
  EXPECT_TRUE(agree(one, {exact({100, 1.00009})}));
  EXPECT_FALSE(agree(one, {exact({100.0002, 1})}));
  EXPECT_FALSE(agree(one, {exact({100, 1.0002})}));
  EXPECT_FALSE(agree(one, {exact({100})}));
  EXPECT_FALSE(agree(one, {exact({})}));
  EXPECT_FALSE(agree(one, {}));
}

TEST(answers, of_calls_that_ended_agree_with_the_same_end_only) {
  EXPECT_TRUE(agree({ended("crash")}, {ended("crash")}));
  EXPECT_FALSE(agree({ended("crash")}, {ended("timeout")}));
  EXPECT_FALSE(agree({ended("crash")}, {exact({})}));
  EXPECT_FALSE(agree({ended("crash: a")}, {ended("crash: b")}));
}

TEST(answers, that_are_not_finite_agree_with_themselves_only) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_TRUE(agree({exact({infinity, 1})}, {exact({infinity, 1})}));
  EXPECT_FALSE(agree({exact({infinity, 1})}, {exact({-infinity, 1})}));
  EXPECT_FALSE(agree({exact({infinity, 1})}, {exact({1e300, 1})}));
  EXPECT_FALSE(agree({exact({nan, 1})}, {exact({1, 1})}));
  EXPECT_TRUE(agree({exact({nan, 1})}, {exact({nan, 1})}));
  EXPECT_FALSE(agree({{"", {nan}, {1}}}, {{"", {1}, {1}}}));
}

// The number of calls of a task that crashes in all of 100 questions except this one.
int calls_of_a_task_that_crashes_but_in(int question) {
  Battery battery({});
  int calls = 0;
  for (int i = 0; i < 100; ++i) {
    battery.ask([&]() -> Battery::Numbers {
      ++calls;
      if (i != question) throw CallEnded{results::Cause::crash, "it was divided by zero"};
      return {1};
    });
  }
  EXPECT_EQ(battery.answers().size(), 100u);
  EXPECT_TRUE(agree({battery.answers().back()}, {ended("crash: it was divided by zero")}));
  return calls;
}

TEST(battery, is_not_asked_to_the_end_of_a_task_that_crashes_from_the_first_call_on) {
  EXPECT_EQ(calls_of_a_task_that_crashes_but_in(-1), 20);
  EXPECT_EQ(calls_of_a_task_that_crashes_but_in(50), 20);
  EXPECT_EQ(calls_of_a_task_that_crashes_but_in(0), 100);
  EXPECT_EQ(calls_of_a_task_that_crashes_but_in(19), 100);
}

// The spread of each number over repeated questions is its error.
TEST(battery, knows_the_errors_of_an_estimator) {
  constexpr int kRepeats = 500, kDraws = 100;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  Battery battery({});
  for (int i = 0; i < kRepeats; ++i) {
    battery.estimate(kDraws, [&](int n, std::uint64_t) {
      std::vector<pt::Rgb> draws(n);
      for (pt::Rgb& each : draws) each = uniform(random) * pt::Rgb{1, 2, 4};
      return draws;
    });
  }
  for (std::size_t k = 0; k < 4; ++k) {  // three means, and their deviation over the mean
    std::vector<double> values, errors;
    for (const Answer& answer : battery.answers()) {
      values.push_back(answer.values.at(k));
      errors.push_back(answer.errors.at(k));
    }
    const double seen = std::sqrt(kRepeats) * pt::mean_of(values).error;
    EXPECT_NEAR(pt::mean_of(errors).value / seen, 1, 0.2) << k;
  }
}

// Means of a hundred answers with five numbers each.
Answers means(std::mt19937& random, double shift, std::size_t shifted) {
  std::normal_distribution<double> normal;
  Answers answers;
  for (std::size_t i = 0; i < 100; ++i) {
    Answer answer;
    for (int k = 0; k < 5; ++k) {
      answer.values.push_back(3 + 0.1 * normal(random) + (i < shifted ? 0.1 * shift : 0));
      answer.errors.push_back(0.1);
    }
    answers.push_back(answer);
  }
  return answers;
}

TEST(answers, that_are_means_agree_unless_chance_does_not_explain_it) {
  std::mt19937 random(1);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    apart += agree(means(random, 0, 0), means(random, 0, 0)) ? 0 : 1;
  }
  EXPECT_LE(apart, 4);  // fewer than one in a thousand: at that rate, 2 are expected
  // One mean is far off, or all are a little: a difference has sqrt 2 errors of one mean.
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(agree(means(random, 12, 1), means(random, 0, 0)));
    EXPECT_FALSE(agree(means(random, 2, 100), means(random, 0, 0)));
  }
}

Fingerprint mistake(const std::string& name, double value, const std::string& breaks) {
  return {name, breaks, "Says " + name + ".", "Look.", {exact({value}), exact({5})}};
}

KnownTask known() {
  return {{exact({1}), exact({5})},
          {mistake("two", 2, "a"), mistake("three", 3, "a"), mistake("also_three", 3, "a"),
           mistake("four", 4, "b")}};
}

std::string names(const KnownTask& task, const Evidence& evidence) {
  std::string all;
  for (const Fingerprint* each : name_by_battery(task, evidence)) {
    all += (all.empty() ? "" : " ") + each->name;
  }
  return all;
}

Evidence evidence(double value, std::set<std::string> broken) {
  return {{exact({value}), exact({5})}, std::move(broken)};
}

TEST(naming, takes_all_evidence_together) {
  const KnownTask task = known();
  EXPECT_EQ(names(task, evidence(2, {"a", "b"})), "two");
  EXPECT_EQ(names(task, evidence(2, {"b"})), "");         // it should break a
  EXPECT_EQ(names(task, evidence(2.5, {"a", "b"})), "");  // other answers
  EXPECT_EQ(names(task, evidence(4, {"b"})), "four");
  Evidence crashed = evidence(2, {"a", "b"});
  crashed.answers[1] = ended("crash");
  EXPECT_EQ(names(task, crashed), "");
}

TEST(naming, gives_one_name_to_what_shows_alike) {
  EXPECT_EQ(names(known(), evidence(3, {"a"})), "three also_three");
  KnownTask task = known();
  for (const char* more : {"again", "and_again"}) task.mistakes.push_back(mistake(more, 3, "a"));
  EXPECT_EQ(names(task, evidence(3, {"a"})), "");  // four sentences help nobody
}

// The submission's noise is too large to distinguish two mistakes that are known to differ.
TEST(naming, says_nothing_where_different_mistakes_explain_it) {
  KnownTask task = known();
  task.mistakes[0].answers[0] = {"", {2}, {0.001}};
  task.mistakes[1].answers[0] = {"", {2.1}, {0.001}};
  Evidence noisy = evidence(2, {"a", "b"});
  noisy.answers[0] = {"", {2.05}, {0.03}};
  EXPECT_EQ(names(task, noisy), "");
  task.mistakes.erase(task.mistakes.begin() + 1);
  EXPECT_EQ(names(task, noisy), "two");
}

TEST(naming, never_names_what_answers_as_the_reference_or_passes) {
  KnownTask task = known();
  task.mistakes.push_back(mistake("unseen", 1, "a"));
  EXPECT_EQ(names(task, evidence(1, {"a"})), "");
  EXPECT_EQ(names(task, evidence(2, {})), "");
}

TEST(answers, are_always_the_same_where_the_questions_do_not_matter) {
  const Answer hit = exact({1, 2}), other_hit = exact({1, 3}), miss = exact({});
  EXPECT_TRUE(always_the_same({}));
  EXPECT_TRUE(always_the_same({hit, hit}));
  EXPECT_FALSE(always_the_same({hit, other_hit}));
  EXPECT_FALSE(always_the_same({hit, hit, miss, other_hit}));
  // There are calls of two kinds, and each kind has its own answer.
  EXPECT_TRUE(always_the_same({hit, exact({7}), hit, exact({7})}));
  EXPECT_TRUE(always_the_same({ended("crash"), ended("crash")}));
  EXPECT_FALSE(always_the_same({ended("crash"), ended("timeout")}));
  // Other noise is not another answer, but another mean is.
  EXPECT_TRUE(always_the_same({{"", {0, 0}, {}}, {"", {0, 0}, {0, 1e-9}}}));
}

// Otherwise the more uncertain mistake would agree with anything.
TEST(answers, of_unlike_noise_do_not_agree) {
  const Answers one{{"", {1, 2}, {0.1, 0}}};
  EXPECT_TRUE(agree(one, {{"", {1.5, 2}, {0.3, 0}}}));
  EXPECT_TRUE(agree(one, {{"", {1.5, 2}, {4, 0}}}));
  EXPECT_FALSE(agree(one, {{"", {1.5, 2}, {6, 0}}}));
  EXPECT_FALSE(agree({{"", {1.5, 2}, {6, 0}}}, one));
}

TEST(answers, are_as_right_only_if_their_errors_are_not_much_larger) {
  const Answer right{"", {1, 2}, {0.1, 0}};
  EXPECT_TRUE(is_as_right({"", {1.2, 2}, {0.1, 0}}, right));
  EXPECT_TRUE(is_as_right({"", {1.2, 2}, {0.15, 1e-9}}, right));
  EXPECT_FALSE(is_as_right({"", {1.4, 2}, {0.1, 0}}, right));
  EXPECT_FALSE(is_as_right({"", {1.2, 2}, {0.3, 0}}, right));
  EXPECT_FALSE(is_as_right({"", {1.2, 2}, {0.1, 0.01}}, right));
}

TEST(known_mistakes, come_back_from_their_file) {
  KnownTask task = known();
  task.right.push_back({"", {1, 2}, {0.5, 0.25}});
  for (Fingerprint& each : task.mistakes) each.answers.push_back({"", {9, 2}, {0.5, 0.25}});
  task.mistakes[1].answers[0] = ended("timeout");
  task.mistakes[2].answers[0] = exact({});
  EXPECT_EQ(known_from_json(to_json(task), "x"), task);
}

TEST(known_mistakes, are_refused_where_the_file_holds_something_else) {
  for (const char* text : {"", "[]", "{}", R"({"right": [], "mistakes": [{}]})"}) {
    EXPECT_THROW(known_from_json(text, "x"), pt::Error) << text;
  }
}

TEST(known_mistakes, are_described_above_their_code) {
  const Fingerprint print = described("m",
                                      "// breaks: a\n// Says what\n// is wrong.\n"
                                      "// hint: Look here,\n// and there.\n#include <a>\n// no\n");
  EXPECT_EQ(print.breaks, "a");
  EXPECT_EQ(print.sentence, "Says what is wrong.");
  EXPECT_EQ(print.hint, "Look here, and there.");
}

TEST(answers, show_nothing_if_all_are_black_or_zero_or_missing) {
  const Answer none = exact({}), black{"", {0, 0, 0, 0, 1}, {0, 0, 0, 0, 0.1}};
  const Answer lit{"", {0, 0.2, 0, 0, 1}, {0, 0.1, 0, 0, 0.1}}, of_the_sampler = exact({2, 1});
  EXPECT_TRUE(shows_nothing({none, exact({0, 0})}));
  EXPECT_FALSE(shows_nothing({none, exact({0, 1})}));
  EXPECT_FALSE(shows_nothing({none, ended("crash")}));
  EXPECT_TRUE(shows_nothing({black, of_the_sampler}));
  EXPECT_FALSE(shows_nothing({black, lit, of_the_sampler}));
  EXPECT_FALSE(shows_nothing({of_the_sampler}));  // a number of a task without estimates
}

// Three calls, right where the answer is 1. Everybody is wrong in the first; so that says less than the other two.
TEST(likeness, is_the_share_of_the_calls_that_both_answer_wrongly) {
  const auto answers = [](double x, double y, double z) {
    return Answers{exact({x}), exact({y}), exact({z})};
  };
  const auto one = [&](const std::string& breaks, const Answers& wrong) {
    return Fingerprint{breaks, breaks, "", "", wrong};
  };
  const KnownTask task{
      answers(1, 1, 1),
      {one("a", answers(2, 2, 1)), one("b", answers(3, 1, 3)), one("c", answers(4, 1, 1))}};
  const Evidence evidence{answers(7, 7, 1), {"a", "b"}};
  const auto found = likeness(task, evidence);
  const double of_the_first = std::log(4 / 3.5), of_another = std::log(4 / 1.5);
  ASSERT_EQ(found.size(), 2u);  // c is not broken
  EXPECT_NEAR(found.at("a"), 1, 1e-12);
  EXPECT_NEAR(found.at("b"), of_the_first / (of_the_first + 2 * of_another), 1e-12);
}

}  // namespace
}  // namespace grader::mistakes
