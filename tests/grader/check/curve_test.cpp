// The measurement of curves: their statistics, and cases without a number.
#include "grader/check/language/curve.h"

#include "grader/check/generators/generators.h"
#include "grader/check/language/property.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

namespace grader::check {
namespace {

const auto nothing = [] {};

Curve curve_of(Statistic statistic, int cases, const std::function<double(double)>& measure) {
  Curve curve;
  curve.places = {1, 10, 100};
  curve.statistic = statistic;
  curve.cases = cases;
  curve.measure = measure;
  return curve;
}

// The numbers 0, 1, 2, ... times the place, from 0 again at the next place.
std::function<double(double)> counted(int cases) {
  return [n = 0, cases](double place) mutable { return place * (n++ % cases); };
}

TEST(curve, statistics_of_known_numbers) {
  const std::pair<Statistic, double> known[] = {
      {Statistic::largest, 8}, {Statistic::mean, 4}, {Statistic::median, 4}};
  for (const auto& [statistic, value] : known) {
    const auto measured = measure(curve_of(statistic, 9, counted(9)), {}, nothing);
    ASSERT_EQ(measured.size(), 3U);
    for (const MeasuredPlace& at : measured) {
      EXPECT_DOUBLE_EQ(at.error, at.place * value);
      EXPECT_EQ(at.cases, 9);
      EXPECT_EQ(at.without, 0);
    }
  }
}

// -1, 1, 3 and 5 times the place: their mean is 2, their variance 20 / 3.
TEST(curve, a_bias_has_the_size_of_a_mean_and_its_standard_error) {
  for (const double sign : {1.0, -1.0}) {
    const auto measured = measure(curve_of(Statistic::bias, 4,
                                           [n = 0, sign](double place) mutable {
                                             return sign * place * (2 * (n++ % 4) - 1);
                                           }),
                                  {}, nothing);
    for (const MeasuredPlace& at : measured) {
      EXPECT_DOUBLE_EQ(at.error, 2 * at.place);
      EXPECT_DOUBLE_EQ(at.noise, at.place * std::sqrt(20.0 / 3 / 4));
    }
  }
  EXPECT_EQ(measure(curve_of(Statistic::mean, 4, counted(4)), {}, nothing)[0].noise, 0);
}

TEST(curve, places_after_the_time_are_not_tried) {
  int tried = 0;
  const auto measured =
      measure(curve_of(Statistic::mean, 1,
                       [&](double) {
                         ++tried;
                         std::this_thread::sleep_for(std::chrono::milliseconds(2));
                         return 0.0;
                       }),
              {.seconds = 1e-3}, nothing);
  EXPECT_EQ(tried, 1);
  ASSERT_EQ(measured.size(), 3U);
  EXPECT_EQ(measured[0].cases, 1);
  for (const int late : {1, 2}) {
    EXPECT_EQ(measured[late].cases, 0);
    EXPECT_TRUE(std::isnan(measured[late].error));
    EXPECT_NE(measured[late].reason, "");
  }
}

TEST(curve, cases_without_a_number_are_counted_apart) {
  int n = 0;
  const auto measured = measure(curve_of(Statistic::largest, 30,
                                         [&](double place) {
                                           ++n;
                                           expect(n % 3 != 0, "a hit", "no hit");
                                           if (n % 3 == 1) return std::nan("");
                                           return place;
                                         }),
                                {}, nothing);
  for (const MeasuredPlace& at : measured) {
    EXPECT_EQ(at.error, at.place);
    EXPECT_EQ(at.cases, 30);
    EXPECT_EQ(at.without, 20);
    EXPECT_EQ(at.reason, "an answer that is not finite");
  }
}

TEST(curve, a_place_without_any_number_ends_soon) {
  int n = 0;
  const auto measured = measure(curve_of(Statistic::mean, 100000,
                                         [&](double place) {
                                           ++n;
                                           expect(place > 10, "a hit", "no hit");
                                           return std::numeric_limits<double>::infinity();
                                         }),
                                {}, nothing);
  EXPECT_LT(n, 300);
  for (const MeasuredPlace& at : measured) {
    EXPECT_TRUE(std::isnan(at.error));
    EXPECT_EQ(at.cases, at.without);
  }
  EXPECT_EQ(measured[0].reason, "no hit");
}

TEST(curve, the_same_seed_gives_the_same_cases_whatever_happened_before) {
  const auto drawn = [](bool fails, std::uint64_t seed) {
    return measure(curve_of(Statistic::largest, 50,
                            [=](double place) {
                              const double number = *real(0, 1);
                              expect(!fails || place > 1, "a hit", "no hit");
                              return number;
                            }),
                   {seed, 1}, nothing);
  };
  EXPECT_EQ(drawn(false, 7)[2].error, drawn(true, 7)[2].error);
  EXPECT_NE(drawn(false, 7)[2].error, drawn(false, 8)[2].error);
  EXPECT_NE(drawn(false, 7)[1].error, drawn(false, 7)[2].error);
}

TEST(curve, more_effort_is_more_cases_and_each_place_begins_anew) {
  int begun = 0;
  const auto measured = measure(curve_of(Statistic::mean, 10, [](double) { return 0.0; }), {1, 2.5},
                                [&] { ++begun; });
  EXPECT_EQ(begun, 3);
  EXPECT_EQ(measured[0].cases, 25);
}

TEST(curve, a_coarse_curve_has_the_same_numbers_at_fewer_places) {
  const auto drawn = [](bool coarse) {
    Curve curve = curve_of(Statistic::mean, 5, [](double) { return *real(0, 1); });
    curve.places = by_factors(1, 64, 7);
    return measure(curve, {.seed = 1, .effort = 1, .coarse = coarse}, nothing);
  };
  const auto all = drawn(false), some = drawn(true);
  ASSERT_EQ(some.size(), 3U);
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some[i].place, all[3 * i].place);
    EXPECT_EQ(some[i].error, all[3 * i].error);
  }
}

TEST(curve, places_by_equal_factors) {
  const std::vector<double> places = by_factors(1e-2, 1e2, 5);
  ASSERT_EQ(places.size(), 5U);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(places[i] / std::pow(10, i - 2), 1, 1e-12);
}

}  // namespace
}  // namespace grader::check
