#pragma once

#include "grader/check/cause.h"
#include "grader/check/show.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

// How a promise of a contract is checked. A property is a GoogleTest named as the promise, in a
// suite named as the task, whose body hands one RapidCheck property to for_all:
//
//   PROMISE(hit_sphere, returns_the_outward_unit_normal) {
//     for_all([] {
//       const AimedRay aimed = *outside_a_sphere();
//       const auto hit = hit_sphere(aimed.sphere, aimed.ray);
//       expect(hit.has_value(), "a hit", "none");
//       expect_near("the length of n", length(hit->n), 1, 1e-12);
//     });
//   }
//
// Everything that varies comes from generators (operator* inside the property), so that a failure
// can be shrunk and replayed; nothing else may be random, and no EXPECT_ or ASSERT_ is used inside,
// since only the functions below make a case fail.

#define PROMISE(task, name) TEST(task, name)

namespace grader::check {

// A failed promise, as every report shows it. All texts are for a person to read.
struct Failure {
  std::string task;
  std::string promise;             // the property's name
  std::vector<std::string> input;  // the shrunk counterexample, a line per value
  std::string what;                // what was compared
  std::string got;
  std::string expected;
  std::string off_by;      // empty where there is no number
  int cases_before = 0;    // how many cases held first
  std::uint64_t seed = 0;  // replays it
  Cause cause = Cause::wrong;
};

// Runs the property on up to `cases` random inputs, or until one fails, and then looks for a
// smaller one for a bounded time. The seed is that of this run (seed()) mixed with the property's
// name.
void for_all(const std::function<void()>& property, int cases = 100);

// From now on, the first failing input is kept and no smaller one is looked for: for who only has
// to know which promises hold.
void never_shrink();

// For a property with nothing random in it.
inline void once(const std::function<void()>& property) { for_all(property, 1); }

// The failures of this process so far, in the order in which they happened.
const std::vector<Failure>& failures();

// The seed of this run: FIRSTLIGHT_SEED, else 1.
std::uint64_t seed();

// Makes the case fail if the condition is false.
void expect(bool condition, const std::string& expected, const std::string& got);

// |got - expected| <= tolerance, and NaN fails. `what` names the quantity.
void expect_near(const std::string& what, double got, double expected, double tolerance);
void expect_near(const std::string& what, pt::Vec3 got, pt::Vec3 expected, double tolerance);
void expect_near(const std::string& what, pt::Rgb got, pt::Rgb expected, double tolerance);

// got == expected, exactly.
void expect_equal(const std::string& what, long long got, long long expected);

// The precision of a color, a BSDF, a pdf or a radiance that the contracts ask for, relative to its
// size: single precision keeps it, and so does pi to six digits.
inline constexpr double kColorPrecision = 1e-5;

// The mean of many draws, and how far it may be from what it estimates by chance.
struct Mean {
  pt::Rgb value;
  pt::Rgb standard_error;
  int n = 0;
  pt::Rgb largest_share;  // how much of the sum of all |draw| is one draw, in [0, 1]; 0 for black
};
Mean mean_of(const std::vector<pt::Rgb>& draws);

// How noisy one draw of a right method may be. The kurtosis (fourth central moment over the squared
// variance: 3 for a normal distribution) says how well the variance is known from many draws.
struct Noise {
  pt::Rgb deviation;  // the largest standard deviation of one draw
  double kurtosis = 30;
};

// The noise of the usual method times the factor that the contract states: from a closed form of
// the usual deviation, as Noise{factor * deviation}, or by this from many draws of a plain textbook
// estimator that runs in the judge's own process, never from the submission's.
Noise noise_of(const std::vector<pt::Rgb>& usual, double factor);

// How many standard errors a mean may be off: by chance 2e-9 of the time on one channel. `slack` is
// added to what is allowed: the error that a right method may have beside chance, as the contract's
// precision says (kColorPrecision times the size of what is expected, and of what the task calls).
//
// What is allowed by chance is measured on the draws, so the draws must not be arbitrarily noisy:
// where more than `at_most` is certain, the case fails as "right on average, but too noisy". Where
// no bound is given, a sum that is mostly one draw is still no evidence.
inline constexpr double kStandardErrors = 6;
void expect_mean(const std::string& what, const Mean& got, pt::Rgb expected, double slack = 0);
void expect_mean(const std::string& what, const Mean& got, pt::Rgb expected, const Noise& at_most,
                 double slack = 0);

// The part of it that is about the noise alone: for draws whose mean is not known.
void expect_noise(const std::string& what, const Mean& got, const Noise& at_most, double slack = 0);

}  // namespace grader::check
