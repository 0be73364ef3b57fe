#include "grader/pictures/statistics/sample_map_verdict.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

constexpr double kMaxOffBatch = 1e-3;
constexpr double kMaxConstantOn = 0.01;
constexpr double kMinCorrelation = 0.75;
constexpr double kMinSlope = 0.88, kMaxSlope = 1.14;
constexpr double kMaxOffset = 0.45;  // batches
// Counts change by whole batches: no pixel gets a smaller deviation than this, in batches.
constexpr double kMinDeviation = 0.15;

bool within(double value, double low, double high) { return value >= low && value <= high; }

bool is_active(const SampleMapReference& reference, std::size_t i) {
  return reference.mean[i] > 1.5 * reference.settings.batch &&
         reference.mean[i] < 0.9 * reference.settings.max_samples;
}

// The mean over the active pixels.
double mean_batches(const SampleMapReference& reference) {
  double active = 0, sum = 0;
  for (std::size_t i = 0; i < reference.mean.size(); ++i) {
    if (!is_active(reference, i)) continue;
    ++active;
    sum += reference.mean[i];
  }
  return active > 0 ? sum / active / reference.settings.batch : 0;
}

// First and second moments of pairs, each with a weight.
struct Pairs {
  double weight = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  void add(double w, double px, double py) {
    weight += w;
    x += w * px;
    y += w * py;
    xx += w * px * px;
    xy += w * px * py;
    yy += w * py * py;
  }
  double var_x() const { return xx / weight - x * x / weight / weight; }
  double var_y() const { return yy / weight - y * y / weight / weight; }
  double covariance() const { return xy / weight - x * y / weight / weight; }
};

// Counts the fractions of the map that break a rule for every pixel.
void count_broken_rules(SampleMapVerdict& verdict, const SampleMapReference& reference,
                        const std::vector<int>& counts) {
  const int max = reference.settings.max_samples, batch = reference.settings.batch;
  int lit = 0, off = 0, outside = 0, on = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int n = counts[i];
    if (n % batch != 0 && n != max) ++off;
    if (n < batch || n > max) ++outside;
    if (reference.constant[i] && !reference.all_zero[i] && reference.always_one_batch[i]) {
      ++lit;
      if (n != batch) ++on;
    }
  }
  const auto pixels = static_cast<double>(counts.size());
  verdict.off_batch = off / pixels;
  verdict.outside = outside / pixels;
  verdict.constant_on = lit > 0 ? static_cast<double>(on) / lit : 0;
}

void fit(SampleMapVerdict& verdict, const SampleMapReference& reference,
         const std::vector<int>& counts) {
  const double batch = reference.settings.batch;
  Pairs logarithms, weighted, plain;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!is_active(reference, i)) continue;
    const double n = counts[i], mean = reference.mean[i];
    const double deviation = std::max(reference.deviation[i], kMinDeviation * batch);
    logarithms.add(1, std::log(mean), std::log(std::max(n, 1.0)));
    weighted.add(1 / (deviation * deviation), mean, n);
    plain.add(1, mean, n);
  }
  if (plain.weight == 0) return;
  verdict.ratio = plain.y / plain.x;
  if (weighted.var_x() > 0) verdict.b = weighted.covariance() / weighted.var_x();
  verdict.a = (weighted.y - verdict.b * weighted.x) / weighted.weight / batch;
  // Equal counts have no correlation with anything; the rest of their variance is rounding.
  const double variances = logarithms.var_x() * logarithms.var_y();
  if (variances > 1e-20) verdict.correlation = logarithms.covariance() / std::sqrt(variances);
}

bool fits(const SampleMapVerdict& v) {
  return v.correlation > kMinCorrelation && within(v.b, kMinSlope, kMaxSlope) &&
         std::abs(v.a) <= kMaxOffset && within(v.ratio, kMinSlope, kMaxSlope);
}

// The rule that is broken first, and how; empty if all hold.
std::string broken_rule(const SampleMapVerdict& v, const SampleMapReference& reference) {
  const int max = reference.settings.max_samples, batch = reference.settings.batch;
  if (!(v.off_batch <= kMaxOffBatch)) {
    return fmt::format(
        "{:.1f} % of the pixels took a number of samples that is not a multiple of the "
        "batch ({}): is the condition checked after every batch, and only then?",
        100 * v.off_batch, batch);
  }
  if (v.outside > 0) {
    return fmt::format(
        "{:.1f} % of the pixels took less than a batch ({}) or more than the "
        "maximum ({})",
        100 * v.outside, batch, max);
  }
  if (!(v.constant_on <= kMaxConstantOn)) {
    return fmt::format(
        "{:.0f} % of the pixels whose samples are all alike took more than one "
        "batch",
        100 * v.constant_on);
  }
  if (fits(v)) return "";
  return fmt::format(
      "the pixels take {:.2f} times the samples that they should (n = {:.2f} batches "
      "+ {:.2f} times the reference's, correlation {:.2f})",
      v.ratio, v.a, v.b, v.correlation);
}

// Names a mistake that the figures of docs/verdicts.md identify. Empty for anything else: a wrong
// hint is worse than none.
std::string likely_cause(const SampleMapVerdict& v, double mean_batches, double most_batches) {
  const bool flat = std::abs(v.b) < 0.05;
  const bool follows = v.correlation > kMinCorrelation;
  if (flat && std::abs(v.a - 1) < 0.1 && mean_batches > 1.5) {
    return "nearly every pixel stops after its first batch";
  }
  if (flat && v.a > 0.95 * most_batches) {
    return "nearly every pixel takes the maximum: can the condition ever be true?";
  }
  if (flat && std::abs(v.correlation) < 0.2) {
    return "the counts do not depend on the pixel: do you add each sample, or the total "
           "so far?";
  }
  if (follows && within(v.b, 0.2, 0.32) && within(v.ratio, 0.2, 0.36)) {
    return "about a quarter of the samples, which a missing factor of 1.96 would explain "
           "(1 / 1.96^2 = 0.26)";
  }
  if (follows && within(v.b, 0.93, 1.07) && within(v.a, -1.15, -0.85)) {
    return "one batch less everywhere: is the last batch counted?";
  }
  return "";
}

}  // namespace

SampleMapVerdict judge_sample_map(const SampleMapReference& reference,
                                  const pt::SampleMap& counts) {
  SampleMapVerdict verdict;
  if (counts.width != reference.width || counts.height != reference.height ||
      counts.counts.size() != reference.mean.size()) {
    verdict.sentence = fmt::format("the sample map is {} x {}, and not {} x {}", counts.width,
                                   counts.height, reference.width, reference.height);
    return verdict;
  }
  count_broken_rules(verdict, reference, counts.counts);
  fit(verdict, reference, counts.counts);
  verdict.sentence = broken_rule(verdict, reference);
  verdict.pass = verdict.sentence.empty();
  if (!verdict.pass) {
    const std::string cause = likely_cause(
        verdict, mean_batches(reference),
        static_cast<double>(reference.settings.max_samples) / reference.settings.batch);
    if (!cause.empty()) verdict.sentence += "; " + cause;
  } else if (std::abs(verdict.b - 1) > 0.04 && std::abs(verdict.b - verdict.ratio) < 0.04) {
    verdict.sentence = fmt::format(
        "right; every pixel takes {:.2f} times as many samples as the reference does: one sample "
        "has {} variance, for example with another chance of survival",
        verdict.b, verdict.b > 1 ? "more" : "less");
  }
  return verdict;
}

}  // namespace grader::pictures
