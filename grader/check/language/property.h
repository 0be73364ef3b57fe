#pragma once

#include "grader/check/language/fail.h"
#include "grader/check/language/show.h"
#include "grader/results/results.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

// The check of a promise of a contract. A property is a GoogleTest with the name of the promise,
// in a suite with the name of the task. Its body hands a RapidCheck property to for_all:
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
// All random values come from generators (operator* inside the property), so that a failure can be
// shrunk and replayed. Nothing else may be random. No EXPECT_ or ASSERT_ is used inside, since only
// the functions below make a case fail.

#define PROMISE(task, name) TEST(task, name)

namespace grader::check {

// A promise that failed in this process.
struct FailedPromise {
  std::string task;     // the slug
  std::string promise;  // the property's name
  results::Failure failure;
};

// Runs the property on up to `cases` random inputs, or until one fails. After a failure it looks
// for a smaller failing input for a limited time. The seed is seed(), mixed with the property's
// name and with the number of the call in the promise: no two calls draw the same inputs.
void for_all(const std::function<void()>& property, int cases = 100);

// The number of calls of for_all that this promise made so far.
int checks_of(const std::string& promise);

// From now on, the first failing input is kept and no smaller one is searched. This is for programs
// that only need to know which promises hold.
void never_shrink();

// The same for a property without random inputs, which says whether anything else is worth trying.
// It counts as a check (checks_of) only if it fails.
void once(const std::function<void()>& property);

// The failures of this process so far, in the order in which they happened.
const std::vector<FailedPromise>& failures();

// The seed of this run: the environment variable FIRSTLIGHT_SEED, or else 1.
std::uint64_t seed();

// Makes the case fail if the condition is false.
void expect(bool condition, const std::string& expected, const std::string& got);

// Makes the case fail unless |got - expected| <= tolerance; NaN fails. `what` names the quantity.
void expect_near(const std::string& what, double got, double expected, double tolerance);
void expect_near(const std::string& what, pt::Vec3 got, pt::Vec3 expected, double tolerance);
void expect_near(const std::string& what, pt::Rgb got, pt::Rgb expected, double tolerance);

// Makes the case fail unless got == expected, exactly.
void expect_equal(const std::string& what, long long got, long long expected);

// The relative precision that the contracts require of a colour, a BSDF, a pdf or a radiance.
// Single precision is enough for it, and so is pi to six digits.
inline constexpr double kColorPrecision = 1e-5;

// The mean of many draws, and its statistical error.
struct Mean {
  pt::Rgb value;
  pt::Rgb standard_error;
  int n = 0;
  pt::Rgb largest_share;  // the largest |draw| over the sum of all |draw|, in [0, 1]; 0 for black
  pt::Rgb deviation;      // of one draw; the two draws farthest from the mean are left out
};
Mean mean_of(const std::vector<pt::Rgb>& draws);

// The noise that one draw of a right method may have. The kurtosis (fourth central moment over the squared
// variance: 3 for a normal distribution) says how well the variance is known from many draws.
struct Noise {
  pt::Rgb deviation;  // the largest standard deviation of one draw
  double kurtosis = 30;
};

// The noise of the usual method times the factor that the contract states. If the usual deviation
// has a closed form, use Noise{factor * deviation}. Otherwise use this function with many draws of
// a plain textbook estimator that runs in the judge's own process, never with those of the
// submission.
Noise noise_of(const std::vector<pt::Rgb>& usual, double factor);

// A mean may be off by this many standard errors. By chance, a right mean exceeds this limit with a
// probability of 2e-9 per channel. `slack` is added to the limit. It is the error that a right
// method may have apart from chance, by the contract's precision: kColorPrecision times the
// expected value, and the same for each task that the method calls.
//
// The standard error is measured on the draws, so the draws must not be arbitrarily noisy. If their
// noise is certainly more than `at_most`, the case fails as "too noisy".
// Without this limit, the case still fails if one draw is most of the sum.
inline constexpr double kStandardErrors = 6;
void expect_mean(const std::string& what, const Mean& got, pt::Rgb expected, double slack = 0);
void expect_mean(const std::string& what, const Mean& got, pt::Rgb expected, const Noise& at_most,
                 double slack = 0);

// Judges only the noise, for draws whose mean is not known.
void expect_noise(const std::string& what, const Mean& got, const Noise& at_most, double slack = 0);

}  // namespace grader::check
