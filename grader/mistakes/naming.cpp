#include "grader/mistakes/naming.h"

#include <algorithm>
#include <cmath>

namespace grader::mistakes {

namespace {

constexpr std::size_t kMaxNames = 3;

constexpr double kPrecision = 1e-6;   // of exact numbers
constexpr double kMaxStandard = 5;    // standard errors that a mean may be off (chance: 6e-7)
constexpr double kMaxKept = 2.5;      // the same, for answers that are left out of the file
constexpr double kMaxNoise = 2;       // times the right error, for such answers
constexpr double kMaxUnlike = 50;     // largest ratio of two errors; fewer draws explain 3
constexpr double kSumDeviations = 4;  // deviations that the sum of squares may be above its mean
constexpr double kCorrelated = 5;     // the means of one answer use the same draws

// The deviation of all numbers that were compared.
struct Deviation {
  bool contradicts = false;
  double largest = 0;  // in standard errors
  double squares = 0;
  int means = 0;

  void add(double a, double b, double error, double scale) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return;  // also if both are infinite
    const double off = std::abs(a - b);
    if (off <= kPrecision * scale) return;
    if (!(error > 0)) {
      contradicts = true;
      return;
    }
    const double z = off / error;
    largest = std::max(largest, std::isfinite(z) ? z : HUGE_VAL);
    squares += z * z;
  }
};

double error_of(const Answer& answer, std::size_t i) {
  return answer.errors.empty() ? 0 : answer.errors[i];
}

double scale_of(const Answer& answer) {
  double scale = 0;
  for (const double value : answer.values) {
    if (std::isfinite(value)) scale = std::max(scale, std::abs(value));
  }
  return scale;
}

void compare(const Answer& a, const Answer& b, Deviation& deviation) {
  if (a.ended != b.ended || a.values.size() != b.values.size()) {
    deviation.contradicts = true;
    return;
  }
  const double scale = std::max(scale_of(a), scale_of(b));
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double error = std::hypot(error_of(a, i), error_of(b, i));
    const double less = std::min(error_of(a, i), error_of(b, i));
    // Means with such different noise are from two estimators, even if the noise covers the difference.
    if (less > kPrecision * scale && error > kMaxUnlike * less) deviation.contradicts = true;
    if (error > kPrecision * scale) ++deviation.means;
    deviation.add(a.values[i], b.values[i], error, scale);
  }
}

// Returns whether the answer is less certain than the right one, like that of an estimator with
// rare bright draws.
bool is_noisier(const Answer& answer, const Answer& right) {
  const double rounding = kPrecision * scale_of(right);
  for (std::size_t i = 0; i < answer.values.size(); ++i) {
    if (error_of(answer, i) > kMaxNoise * error_of(right, i) + rounding) return true;
  }
  return false;
}

}  // namespace

bool explains(const Fingerprint& mistake, const Evidence& evidence) {
  return evidence.broken.contains(mistake.breaks) && agree(evidence.answers, mistake.answers);
}

std::vector<const Fingerprint*> name_by_battery(const KnownTask& known, const Evidence& evidence) {
  if (evidence.broken.empty() || agree(evidence.answers, known.right)) return {};
  std::vector<const Fingerprint*> found;
  for (const Fingerprint& mistake : known.mistakes) {
    if (explains(mistake, evidence)) found.push_back(&mistake);
  }
  for (const Fingerprint* one : found) {
    if (!agree(one->answers, found[0]->answers)) return {};
  }
  if (found.size() > kMaxNames) return {};
  return found;
}

std::map<std::string, double> likeness(const KnownTask& known, const Evidence& evidence) {
  const std::size_t calls = std::min(evidence.answers.size(), known.right.size());
  const auto mistakes = static_cast<double>(known.mistakes.size());
  // A call that is left out of the file of a known mistake has the right answer there.
  std::vector<bool> wrong(calls);
  std::vector<int> wrong_in(calls);
  const auto is_wrong_in = [&](const Fingerprint& mistake, std::size_t call) {
    return !(mistake.answers.at(call) == known.right[call]);
  };
  for (std::size_t call = 0; call < calls; ++call) {
    wrong[call] = !is_as_right(evidence.answers[call], known.right[call]);
    wrong_in[call] = static_cast<int>(std::ranges::count_if(
        known.mistakes, [&](const Fingerprint& each) { return is_wrong_in(each, call); }));
  }
  std::map<std::string, double> found;
  for (const Fingerprint& mistake : known.mistakes) {
    if (!evidence.broken.contains(mistake.breaks)) continue;
    double in_both = 0, in_one = 0;
    for (std::size_t call = 0; call < calls; ++call) {
      const bool other = is_wrong_in(mistake, call);
      const double weight = std::log((mistakes + 1) / (wrong_in[call] + 0.5));
      if (wrong[call] && other) in_both += weight;
      if (wrong[call] || other) in_one += weight;
    }
    double& most = found[mistake.breaks];
    if (in_one > 0) most = std::max(most, in_both / in_one);
  }
  return found;
}

bool agree(const Answers& a, const Answers& b) {
  if (a.size() != b.size()) return false;
  Deviation all;
  for (std::size_t i = 0; i < a.size() && !all.contradicts; ++i) compare(a[i], b[i], all);
  const double allowed = all.means + kSumDeviations * std::sqrt(2 * kCorrelated * all.means);
  return !all.contradicts && all.largest <= kMaxStandard && all.squares <= allowed;
}

bool is_as_right(const Answer& answer, const Answer& right) {
  Deviation one;
  compare(answer, right, one);
  return !one.contradicts && one.largest <= kMaxKept && !is_noisier(answer, right);
}

}  // namespace grader::mistakes
