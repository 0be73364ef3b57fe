#include "grader/check/language/property.h"

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/generators.h"
#include "grader/check/generators/special.h"
#include "grader/check/language/fail.h"
#include "grader/check/language/find_failure.h"
#include "grader/check/language/two_numbers.h"
#include "pt/sampling/sampler.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace grader::tests {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

// Runs a property that fails, and returns what it writes for the reports.
results::Failure failure_of(const std::function<void()>& property) {
  EXPECT_NONFATAL_FAILURE(check::for_all(property), "input");
  return check::failures().back().failure;
}

TEST(Property, shows_the_simplest_input_that_fails_by_its_name) {
  const results::Failure failure = failure_of([] {
    const double x = check::draw("x", check::real(-10, 10));
    const int n = check::draw("n", check::whole(2, 50));
    const pt::Vec3 d = *check::direction();
    check::expect(x < 4.25 || n < 0 || length(d) < 0, "less", "more");
  });
  ASSERT_EQ(failure.input.size(), 3u);
  EXPECT_TRUE(failure.input[0] == "x: 5" || failure.input[0] == "x: 10") << failure.input[0];
  EXPECT_EQ(failure.input[1], "n: 2");
  EXPECT_EQ(failure.input[2], "(0, 0, 1)");
  EXPECT_EQ(failure.expected, "less");
  EXPECT_EQ(failure.got, "more");
}

TEST(Property, shrinks_a_magnitude_to_a_power_of_ten) {
  const results::Failure failure = failure_of([] {
    const double x = check::draw("x", check::magnitude(1e-6, 1e6));
    check::expect(x < 30, "less", "more");
  });
  EXPECT_EQ(failure.input, std::vector<std::string>{"x: 100"});
}

TEST(Property, runs_the_smallest_failing_case_once_more_for_a_debugger) {
  setenv("FIRSTLIGHT_REPLAY", "1", 1);
  int last = 0;
  const results::Failure failure = failure_of([&] {
    last = check::draw("n", check::whole(0, 1000));
    check::expect(last < 17, "less", "more");
  });
  unsetenv("FIRSTLIGHT_REPLAY");
  EXPECT_EQ(failure.input, std::vector<std::string>{"n: " + std::to_string(last)});
  EXPECT_EQ(last, 17);
}

TEST(Property, shows_what_was_thrown) {
  const results::Failure failure = failure_of([] {
    if (check::draw("n", check::whole(0, 1000)) > 16) throw std::runtime_error("too many");
  });
  EXPECT_NE(failure.got.find("too many"), std::string::npos) << failure.got;
  EXPECT_EQ(failure.input, std::vector<std::string>{"n: 17"});
}

// As many as are allowed, however long one takes: every machine shows the same input.
TEST(Property, tries_as_many_smaller_inputs_on_every_machine) {
  const auto calls_with = [](int numbers) {
    int calls = 0;
    const auto fails = [&] {
      ++calls;
      for (int i = 0; i < numbers; ++i) check::draw("x", check::real(900, 1000));
      check::expect(false, "more", "less");
    };
    check::find_failure(fails, {.seed = 1, .cases = 100});
    return calls;
  };
  constexpr int kMost = 201;  // RapidCheck makes an input of each try, and runs it
  EXPECT_LE(calls_with(600), kMost);
  EXPECT_LE(calls_with(1200), kMost);
  EXPECT_LT(calls_with(20), calls_with(600));
}

// A hundred steps make few of so many numbers simpler, but an input of simple numbers fails as well.
TEST(Property, shows_simple_values_where_they_fail_too) {
  const results::Failure failure = failure_of([] {
    for (int i = 0; i < 300; ++i) {
      check::draw("x", check::real(900, 1000));
      check::draw("n", check::whole(7, 1000));
      check::draw("d", check::direction());
    }
    check::expect(false, "more", "less");
  });
  EXPECT_TRUE(failure.simple);
  ASSERT_EQ(failure.input.size(), 900u);
  const std::set<std::string> known{"x: 900",        "x: 950",        "x: 1000",
                                    "n: 7",          "n: 8",          "n: 9",
                                    "d: (0, 0, 1)",  "d: (1, 0, 0)",  "d: (0, 1, 0)",
                                    "d: (0, 0, -1)", "d: (-1, 0, 0)", "d: (0, -1, 0)"};
  for (const std::string& line : failure.input) EXPECT_TRUE(known.contains(line)) << line;
}

TEST(Property, makes_the_failing_input_smaller_where_simple_values_hold) {
  const auto has_a_part_below_a_unit = [](double x) { return x != std::round(x); };
  const results::Failure failure = failure_of([&] {
    const double x = check::draw("x", check::real(0, 20));
    check::draw("y", check::real(900, 1000));
    check::expect(!has_a_part_below_a_unit(x), "a whole number", "another");
  });
  EXPECT_FALSE(failure.simple);
  EXPECT_EQ(failure.input[1], "y: 1000");
}

struct Drawn {
  std::vector<int> numbers;
};

void showValue(const Drawn& drawn, std::ostream& out) {
  for (const int each : drawn.numbers) out << "number " << each << "\n";
}

// RapidCheck makes the failing input once more to show it. No smaller one fails here.
TEST(Property, shows_the_simple_input_that_failed) {
  const results::Failure failure = failure_of([&] {
    const Drawn drawn = *rc::gen::exec([] {
      Drawn made;
      const int count = *check::whole(1, 9);
      for (int i = 0; i < count; ++i) made.numbers.push_back(*check::whole(3, 5));
      return made;
    });
    check::expect(drawn.numbers != std::vector<int>{5}, "another list", "five");
  });
  EXPECT_TRUE(failure.simple);
  EXPECT_EQ(failure.input, std::vector<std::string>{"number 5"});
}

// A simple input that fails for another reason is not shown, either.
TEST(Property, keeps_the_cause_where_a_simple_input_has_another) {
  const results::Failure failure = failure_of([] {
    const int n = check::draw("n", check::whole(0, 1000));
    if (n > 10) check::expect(false, "more", "less");
    check::fail_call(results::Cause::crash, "signal 11");
  });
  EXPECT_EQ(failure.cause, results::Cause::wrong);
  EXPECT_FALSE(failure.simple);
}

// A smaller input that fails for another reason is not shown: the verdict is that of the first.
TEST(Property, keeps_the_cause_of_the_first_failure) {
  const results::Failure failure = failure_of([] {
    const int n = check::draw("n", check::whole(20, 1000));
    if (n > 40) check::fail_call(results::Cause::crash, "signal 11");
    check::expect(false, "more", "less");
  });
  EXPECT_EQ(failure.cause, results::Cause::crash);
  EXPECT_EQ(failure.got, "signal 11");
}

// Each crash costs a new process, and one small input is enough.
TEST(Property, looks_less_for_small_inputs_that_crash_once_another_promise_crashed) {
  int calls = 0;
  const auto crashes = [&] {
    ++calls;
    for (int i = 0; i < 8; ++i) check::draw("x", check::real(0, 1000));
    check::fail_call(results::Cause::crash, "signal 11");
  };
  check::find_failure(crashes, {.seed = 1, .cases = 100});
  const int at_first = calls;
  failure_of(crashes);
  calls = 0;
  failure_of(crashes);
  EXPECT_LT(calls, at_first);
  EXPECT_GT(calls, 1);
}

struct Two {
  pt::Vec3 first, second;
};

void showValue(const Two& two, std::ostream& out) { check::show_lines(out, two.first, two.second); }

TEST(Property, shows_a_value_of_several_lines_as_several_inputs) {
  const results::Failure failure = failure_of([] {
    const Two two = *rc::gen::exec([] { return Two{*check::point(), *check::direction()}; });
    check::expect(length(two.first) < 0, "less", "more");
  });
  EXPECT_EQ(failure.input, (std::vector<std::string>{"(0, 0, 0)", "(0, 0, 1)"}));
}

struct Unshown {};

// Nobody could say what a number means that has no name.
TEST(Property, leaves_out_numbers_without_a_name_and_what_cannot_be_shown) {
  const results::Failure failure = failure_of([] {
    const int unnamed = *check::whole(3, 50);
    const bool flag = *rc::gen::arbitrary<bool>();
    [[maybe_unused]] const Unshown unshown = *rc::gen::just(Unshown{});
    const int n = check::draw("n", check::whole(2, 50));
    check::expect(n < 0 || unnamed < 0 || (flag && n < 0), "less", "more");
  });
  EXPECT_EQ(failure.input, std::vector<std::string>{"n: 2"});
}

// A promise asks for one generator more than once, to try more inputs.
TEST(Property, draws_other_inputs_at_each_call) {
  std::vector<double> drawn;
  for (int call = 0; call < 3; ++call) {
    check::for_all([&] { drawn.push_back(*check::real(0, 1)); }, 1);
    check::once([] {});
  }
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_NE(drawn[0], drawn[1]);
  EXPECT_NE(drawn[1], drawn[2]);
}

TEST(Property, counts_its_checks) {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  EXPECT_EQ(check::checks_of(name), 0);
  check::for_all([] {});
  failure_of([] { check::expect(false, "less", "more"); });
  check::once([] {});
  EXPECT_EQ(check::checks_of(name), 2);
  EXPECT_NONFATAL_FAILURE(check::once([] { check::expect(false, "less", "more"); }), "input");
  EXPECT_EQ(check::checks_of(name), 3);
}

TEST(Property, says_by_which_factor_a_colour_is_off) {
  const auto off_by = [](pt::Rgb got, pt::Rgb expected) {
    return failure_of([&] { check::expect_near("a colour", got, expected, 1e-6); }).off_by;
  };
  EXPECT_EQ(off_by({1, 3, 2}, {1, 2, 2}), "1 (1.5 times the expected value)");
  EXPECT_EQ(off_by({0, 0, 2}, {}), "2");
}

TEST(Property, fails_on_nan) {
  failure_of([] { check::expect_near("a number", kNan, 0, 1e9); });
  failure_of([] { check::expect_near("a number", 0, kNan, 1e9); });
  failure_of([] { check::expect_near("a vector", pt::Vec3{0, kNan, 0}, {}, 1e9); });
  failure_of([] { check::expect_near("a colour", pt::Rgb{0, 0, kNan}, {}, 1e9); });
}

TEST(Property, stays_in_the_range_of_its_generators) {
  check::for_all([] {
    const double x = *check::real(-0.3, 0.7), y = *check::magnitude(2, 300);
    check::expect(x >= -0.3 && x <= 0.7, "in [-0.3, 0.7]", check::show(x));
    check::expect(y >= 2 && y <= 300, "in [2, 300]", check::show(y));
    check::expect_near("the length of a direction", length(*check::direction()), 1, 1e-15);
    const pt::Frame frame = *check::rotation();
    check::expect_near("z", cross(frame.x, frame.y), frame.z, 1e-14);
  });
}

// A direction may have one component, and others so small that their squares are zero.
TEST(Property, exchanges_numbers_of_a_ray_but_leaves_its_direction_a_length) {
  check::for_all(
      [] {
        pt::Ray ray{*check::point(10), {}};
        ray.direction[*check::whole(0, 2)] = *check::any_length();
        ray.direction = check::with_other_zeros(ray.direction);
        check::exchange_or_add_in(ray);
        const double now = length(ray.direction);
        check::expect(now > 0.99e-9 && now < 1.01e9, "a billionth to a billion", check::show(now));
      },
      2000);
}

// All shrinks of these values lie in the range too, and shrinking ends.
TEST(Property, shrinks_within_the_range_and_ends) {
  for (const auto& [low, high] :
       {std::pair{0.0, 1.0}, std::pair{0.1, 0.15}, std::pair{-7.0, 1e3}}) {
    auto shrinkable = check::real(low, high)(rc::Random(7));
    int steps = 0;
    for (bool last = false; !last && steps < 10000; ++steps) {
      // Always takes the last candidate: the longest way down.
      auto candidates = shrinkable.shrinks();
      last = true;
      while (auto next = candidates.next()) {
        shrinkable = *next;
        last = false;
      }
      EXPECT_GE(shrinkable.value(), low);
      EXPECT_LE(shrinkable.value(), high);
    }
    EXPECT_LT(steps, 2000) << low << " " << high;
  }
}

// Learners read inputs in this form and copy them.
TEST(Show, says_which_number_is_which) {
  EXPECT_EQ(check::show(pt::Ray{{1, 2, 3}, {4, 5, 6}, 0.5, 7}),
            "Ray from (1, 2, 3) along (4, 5, 6), t in [0.5, 7]");
  EXPECT_EQ(
      check::show(pt::Triangle{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}, {6, 0, 0}}),
      "Triangle (1, 0, 0) (2, 0, 0) (3, 0, 0), normals (4, 0, 0) (5, 0, 0) (6, 0, 0)");
  EXPECT_EQ(check::show(pt::Camera{{1, 2, 3}, {}, 60, 40, 0.1, 9}),
            "Camera at (1, 2, 3), right (1, 0, 0), up (0, 1, 0), back (0, 0, 1), field of view "
            "60 x 40 degrees, clip [0.1, 9]");
  EXPECT_EQ(check::show(pt::Box{{1, 2, 3}, {4, 5, 6}}), "Box from (1, 2, 3) to (4, 5, 6)");
  EXPECT_EQ(check::show(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(check::brief(pt::Rgb{1 / 3., -0.0, 123456}), "(r 0.33333, g 0, b 1.2346e+05)");
}

TEST(Property, draws_every_hue) {
  std::set<std::vector<double>> hues;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const pt::Rgb hue = check::hue()(rc::Random(seed), 100).value();
    hues.insert({hue.r, hue.g, hue.b});
  }
  std::set<std::vector<double>> all;
  for (const double r : {0, 1}) {
    for (const double g : {0, 1}) {
      for (const double b : {0, 1}) all.insert({r, g, b});
    }
  }
  all.erase({0, 0, 0});
  EXPECT_EQ(hues, all);
}

// Samples with mean 1: `value` with probability 1 / value, else 0.
std::vector<pt::Rgb> rarely(double value, int n, std::uint64_t seed) {
  pt::Sampler sampler(seed);
  std::vector<pt::Rgb> draws(n);
  for (pt::Rgb& draw : draws) draw = pt::gray(sampler.next_1d() * value < 1 ? value : 0);
  return draws;
}

TEST(Mean, of_estimates_as_noisy_as_they_may_be_is_right) {
  check::for_all(
      [] {
        const std::vector<pt::Rgb> draws =
            rarely(5, 3000, check::draw("seed", check::sampler_seed()));
        check::expect_mean("the mean", check::mean_of(draws), pt::gray(1),
                           check::Noise{pt::gray(2)});
        check::expect_mean("the mean", check::mean_of(draws), pt::gray(1),
                           check::noise_of(draws, 1));
      },
      1000);
}

// The weights of a density that is steeper than the cosine: 2 / (3 z), where z is the largest of three
// random numbers. Their deviation is sqrt(1/3), but the mean of their fourth powers is infinite.
TEST(Mean, of_weights_without_a_kurtosis_is_right) {
  check::for_all(
      [] {
        pt::Sampler sampler(check::draw("seed", check::sampler_seed()));
        std::vector<pt::Rgb> draws(4000);
        for (pt::Rgb& draw : draws) {
          const double z = std::max({sampler.next_1d(), sampler.next_1d(), sampler.next_1d()});
          draw = pt::gray(2 / (3 * z));
        }
        check::expect_mean("the mean", check::mean_of(draws), pt::gray(1),
                           check::Noise{pt::gray(1)});
      },
      1000);
}

TEST(Mean, is_too_noisy_where_few_draws_carry_it) {
  const results::Failure noisy = failure_of([] {
    const std::vector<pt::Rgb> draws = rarely(50, 3000, check::draw("seed", check::sampler_seed()));
    check::expect_mean("the mean", check::mean_of(draws), pt::gray(1), check::Noise{pt::gray(2)});
  });
  EXPECT_TRUE(noisy.got.starts_with("too noisy, although the mean may be right")) << noisy.got;
  EXPECT_EQ(noisy.got.find("of their sum"), std::string::npos) << noisy.got;
  const results::Failure one = failure_of([] {
    std::vector<pt::Rgb> draws(1000);
    draws[17] = pt::gray(1000);
    check::expect_mean("the mean", check::mean_of(draws), pt::gray(2));
  });
  EXPECT_TRUE(one.got.starts_with("too noisy to judge the mean")) << one.got;
  const results::Failure large = failure_of([] {
    std::vector<pt::Rgb> draws(1000, pt::gray(1));
    draws[17] = draws[18] = draws[19] = pt::gray(100);
    check::expect_mean("the mean", check::mean_of(draws), pt::gray(1.3), check::Noise{pt::gray(1)});
  });
  EXPECT_TRUE(large.got.ends_with("; one of 1000 is 8 % of their sum")) << large.got;
  const results::Failure far = failure_of([] {
    check::expect_mean(
        "the mean", check::mean_of(rarely(500, 5000, check::draw("seed", check::sampler_seed()))),
        pt::gray(3), check::Noise{pt::gray(1)});
  });
  EXPECT_TRUE(far.got.starts_with("too noisy to judge the mean")) << far.got;
}

TEST(Mean, that_is_off_is_told_by_its_factor) {
  const std::vector<pt::Rgb> half(100, pt::gray(0.5));
  EXPECT_EQ(
      failure_of([&] { check::expect_mean("the mean", check::mean_of(half), pt::gray(1)); }).off_by,
      "0.5 (0.5 times the expected value)");
}

// 30 of 39 are 77 %.
TEST(Mean, of_few_draws_is_told_by_the_part_of_the_largest) {
  std::vector<pt::Rgb> draws(10, pt::gray(1));
  draws[3] = pt::gray(30);
  const results::Failure failure =
      failure_of([&] { check::expect_mean("the mean", check::mean_of(draws), pt::gray(3.9)); });
  EXPECT_EQ(failure.got, "too noisy to judge the mean: one of 10 estimates is 77 % of their sum");
}

// The standard deviation of 0 and 2 is sqrt(2), with n - 1.
TEST(Mean, may_be_as_noisy_as_the_usual_method_times_the_factor) {
  const std::vector<pt::Rgb> usual{pt::gray(0), pt::gray(2)};
  for (const double factor : {1.0, 3.0}) {
    EXPECT_NEAR(check::noise_of(usual, factor).deviation.g, factor * std::sqrt(2), 1e-14);
  }
}

TEST(Mean, without_noise_may_be_as_imprecise_as_the_contract_says) {
  const std::vector<pt::Rgb> draws(100, pt::gray(1 + 9e-6));
  check::once([&] {
    check::expect_mean("the mean", check::mean_of(draws), pt::gray(1), check::Noise{},
                       check::kColorPrecision);
  });
  failure_of([&] {
    check::expect_mean("the mean", check::mean_of(draws), pt::gray(1), check::Noise{}, 1e-6);
  });
  failure_of([&] {
    check::expect_mean("the mean", check::mean_of(draws), pt::gray(kNan), check::Noise{}, 1);
  });
}

TEST(Mean, that_is_not_a_number_is_never_right) {
  const pt::Rgb one = pt::gray(1);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<pt::Rgb> draws(100, one);
    draws[30][channel] = kNan;
    const check::Mean bad = check::mean_of(draws);
    failure_of([&] { check::expect_mean("the mean", bad, one); });
    failure_of([&] { check::expect_mean("the mean", bad, one, 1e9); });
    failure_of([&] { check::expect_mean("the mean", bad, one, check::Noise{one}, 1e9); });
    failure_of([&] { check::expect_noise("the mean", bad, check::Noise{one}, 1e9); });

    // Each number is tested separately.
    check::Mean only_value{one, {}, 100, {}, {}}, only_error = only_value, only_noise = only_value;
    only_value.value[channel] = kNan;
    only_error.standard_error[channel] = kNan;
    only_noise.deviation[channel] = kNan;
    for (const check::Mean& mean : {only_value, only_error}) {
      failure_of([&] { check::expect_mean("the mean", mean, one, 1e9); });
      failure_of([&] { check::expect_mean("the mean", mean, one, check::Noise{one}, 1e9); });
    }
    failure_of([&] { check::expect_mean("the mean", only_noise, one, check::Noise{one}, 1e9); });
    failure_of([&] { check::expect_noise("the mean", only_noise, check::Noise{one}, 1e9); });

    pt::Rgb truth = one;
    truth[channel] = kNan;
    const check::Mean good = check::mean_of(std::vector<pt::Rgb>(100, one));
    failure_of([&] { check::expect_mean("the mean", good, truth, 1e9); });
    failure_of([&] { check::expect_mean("the mean", good, truth, check::Noise{one}, 1e9); });
  }
}

TEST(Cameras, know_the_way_back_to_the_picture) {
  pt::Camera camera;
  camera.hfov_deg = 90;
  camera.vfov_deg = 2 * std::atan(0.5) * 180 / pt::kPi;
  const pt::Vec2 corner = check::on_picture(camera, {3, 1.5, -3});
  EXPECT_NEAR(corner.x, 1, 1e-15);
  EXPECT_NEAR(corner.y, 1, 1e-15);
  EXPECT_NEAR(check::on_picture(camera, {-1, 0, -2}).x, 0.25, 1e-15);
  EXPECT_TRUE(std::isnan(check::on_picture(camera, {0, 0, 1}).x));
}

// Pairs in which the second number is the fraction of slope times the first.
std::vector<check::NumberPair> pairs_on_lines(double slope, bool exchanged) {
  pt::Sampler random(7);
  std::vector<check::NumberPair> pairs;
  for (int i = 0; i < 1200; ++i) {
    const double x = random.next_1d(), y = slope * x + 0.3;
    const double part = y - std::floor(y);
    pairs.push_back(exchanged ? check::NumberPair{part, x} : check::NumberPair{x, part});
  }
  return pairs;
}

TEST(two_numbers, are_dependent_if_they_lie_on_lines) {
  for (const double slope : {1.0, -3.0, 64.0, -2000.0, 0.5, -1999.5}) {
    for (const bool exchanged : {false, true}) {
      EXPECT_THROW(check::expect_two_numbers("", pairs_on_lines(slope, exchanged)),
                   check::CaseFailed)
          << slope << exchanged;
    }
  }
}

TEST(two_numbers, are_dependent_on_any_curve) {
  pt::Sampler random(7);
  std::vector<check::NumberPair> along_x, along_y;
  for (int i = 0; i < 1200; ++i) {
    const double x = random.next_1d(), y = std::fmod(900 * x * x, 1.0);
    along_x.push_back({x, y});
    along_y.push_back({y, x});
  }
  EXPECT_THROW(check::expect_two_numbers("", along_x), check::CaseFailed);
  EXPECT_THROW(check::expect_two_numbers("", along_y), check::CaseFailed);
}

TEST(two_numbers, are_independent_where_one_is_always_nearly_the_same) {
  pt::Sampler random(7);
  std::vector<check::NumberPair> pairs;
  for (int i = 0; i < 1200; ++i) {
    const pt::Vec2 at = random.next_2d();
    pairs.push_back({at.x, std::fmod(0.97 + at.y / 15, 1.0)});
  }
  EXPECT_NO_THROW(check::expect_two_numbers("", pairs));
}

TEST(two_numbers, are_finite) {
  pt::Sampler random(7);
  std::vector<check::NumberPair> pairs;
  for (int i = 0; i < 1200; ++i) pairs.push_back({random.next_1d(), random.next_1d()});
  EXPECT_NO_THROW(check::expect_two_numbers("", pairs));
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    pairs[7].y = bad;
    EXPECT_EQ(failure_of([&] { check::expect_two_numbers("", pairs); }).got,
              "a number that is not finite");
  }
}

TEST(two_numbers, are_independent_if_a_sampler_draws_both) {
  for (int seed = 0; seed < 20; ++seed) {
    pt::Sampler random(seed);
    std::vector<check::NumberPair> pairs;
    for (int i = 0; i < 1200; ++i) {
      const pt::Vec2 at = random.next_2d();
      pairs.push_back({at.x, at.y, i % 3 == 0 ? 2.0 : 1.0});
    }
    EXPECT_NO_THROW(check::expect_two_numbers("", pairs)) << seed;
  }
}

}  // namespace
}  // namespace grader::tests
