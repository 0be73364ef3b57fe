#include "grader/check/language/curve.h"

#include "grader/check/language/fail.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <rapidcheck.h>

namespace grader::check {

namespace {

std::vector<NamedCurve>& kept_curves() {
  static std::vector<NamedCurve> all;
  return all;
}

// If this many cases of a place give no number, further cases would only take time.
constexpr int kWithoutAny = 20;

constexpr std::size_t kCoarse = 3;

constexpr const char* kNoTimeLeft = "not tried: earlier calls took all the time of a curve";

double average(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum / static_cast<double>(numbers.size());
}

// The standard error of the mean of at least two numbers.
double standard_error(const std::vector<double>& numbers) {
  const double mean = average(numbers);
  double sum = 0;
  for (const double number : numbers) sum += (number - mean) * (number - mean);
  const auto n = static_cast<double>(numbers.size());
  return n > 1 ? std::sqrt(sum / (n - 1) / n) : 0;
}

double statistic_of(Statistic statistic, std::vector<double>& errors) {
  if (errors.empty()) return std::numeric_limits<double>::quiet_NaN();
  switch (statistic) {
    case Statistic::largest:
      return *std::max_element(errors.begin(), errors.end());
    case Statistic::mean:
      return average(errors);
    case Statistic::bias:
      return std::abs(average(errors));
    case Statistic::median:
      break;
  }
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

// RapidCheck lets generators be used inside another one.
double one_case(const Curve& curve, double place, const rc::Random& random) {
  return rc::gen::exec([&] { return curve.measure(place); })(random, rc::kNominalSize).value();
}

MeasuredPlace measure_place(const Curve& curve, double place, rc::Random& random, int cases) {
  MeasuredPlace measured;
  measured.place = place;
  std::vector<double> errors;
  const auto nothing = [&](const std::string& reason) {
    if (measured.without++ == 0) measured.reason = reason;
  };
  for (; measured.cases < cases; ++measured.cases) {
    if (errors.empty() && measured.without >= kWithoutAny) break;
    try {
      const double error = one_case(curve, place, random.split());
      if (std::isfinite(error)) {
        errors.push_back(error);
      } else {
        nothing("an answer that is not finite");
      }
    } catch (const CaseFailed& failed) {
      nothing(failed.failure.got);
      measured.ended = measured.ended || failed.failure.cause != results::Cause::wrong;
    }
  }
  if (curve.statistic == Statistic::bias && !errors.empty())
    measured.noise = standard_error(errors);
  measured.error = statistic_of(curve.statistic, errors);
  return measured;
}

}  // namespace

std::vector<MeasuredPlace> measure(const Curve& curve, const CurveSettings& settings,
                                   const std::function<void()>& begin) {
  const int cases = std::max(1, static_cast<int>(std::lround(curve.cases * settings.effort)));
  const auto start = std::chrono::steady_clock::now();
  rc::Random random(settings.seed);
  std::vector<MeasuredPlace> all;
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    rc::Random of_place = random.split();  // does not depend on other places
    if (settings.coarse && i % kCoarse != 0) continue;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (passed.count() > settings.seconds) {
      all.push_back({.place = curve.places[i], .error = std::nan(""), .reason = kNoTimeLeft});
      continue;
    }
    begin();
    all.push_back(measure_place(curve, curve.places[i], of_place, cases));
  }
  return all;
}

const std::vector<NamedCurve>& curves() { return kept_curves(); }

bool keep_curve(const char* task, const char* name, Curve (*make)()) {
  kept_curves().push_back({task, name, make()});
  return true;
}

std::function<double(double)> at_most(double limit) {
  return [limit](double) { return limit; };
}

std::vector<double> by_factors(double first, double last, int count) {
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    places.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  }
  return places;
}

}  // namespace grader::check
