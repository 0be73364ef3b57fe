#include "grader/explain/explain.h"

namespace grader::explain {

using pt::Rgb;

namespace {

Rgb mean_of(std::span<const Rgb> radiances) {
  Rgb sum;
  for (const Rgb& radiance : radiances) sum += radiance;
  return sum / static_cast<double>(radiances.size());
}

// A float sum is less precise the longer it is.
bool is_mean(Rgb got, Rgb mean, std::size_t samples) {
  const double tolerance = std::max(2e-5, 2e-7 * static_cast<double>(samples));
  for (int channel = 0; channel < 3; ++channel) {
    if (!(std::abs(got[channel] - mean[channel]) <= tolerance * std::abs(mean[channel])))
      return false;
  }
  return true;
}

Explanation another_mean(const char* promise, Rgb got, Rgb mean, std::size_t samples) {
  return {Fault::structure,
          promise,
          brief(got),
          "the mean of the " + std::to_string(samples) + " radiances, " + brief(mean),
          mean,
          got - mean};
}

// The condition after n samples: dividing by n or by n - 1, and within its precision, a right solution
// must stop or may stop.
struct Condition {
  bool must_stop = false, may_stop = false;
};

// Mean and squared distances of the luminance so far (Welford 1962), in long double.
class Spread {
 public:
  void add(double value) {
    ++n_;
    const long double distance = value - mean_;
    mean_ += distance / n_;
    squares_ += distance * (value - mean_);
  }

  Condition condition(double tolerance) const {
    constexpr long double kPrecision = 3e-5L;
    const long double n = n_, limit = tolerance * mean_;
    // Sums of squares in double are off by this much of the squared mean.
    const long double rounding = 1.96L * std::abs(mean_) * 0x1p-24L / std::sqrt(n);
    const long double least = 1.96L * std::sqrt(squares_ / n / n);
    const long double most = 1.96L * std::sqrt(squares_ / (n - 1) / n);
    return {most * (1 + kPrecision) + rounding < limit,
            least * (1 - kPrecision) - rounding <= limit};
  }

 private:
  long long n_ = 0;
  long double mean_ = 0, squares_ = 0;
};

}  // namespace

Explanation explain_pixel(int samples, Rgb mean, std::span<const Rgb> radiances) {
  if (std::ssize(radiances) != samples) {
    return {Fault::structure, "takes_the_samples_asked_for",
            std::to_string(radiances.size()) + " calls of radiance() for " +
                std::to_string(samples) + " samples",
            "one call per sample"};
  }
  const Rgb right = mean_of(radiances);
  if (is_mean(mean, right, radiances.size())) return {};
  return another_mean("averages_the_radiance", mean, right, radiances.size());
}

Explanation explain_adaptive(const pt::AdaptiveSettings& settings,
                             const pt::PixelEstimate& estimate, std::span<const Rgb> radiances) {
  const auto taken = std::ssize(radiances);
  if (taken != estimate.samples || taken < 1 || taken > settings.max_samples) {
    return {Fault::structure, "never_exceeds_the_maximum",
            std::to_string(taken) + " calls of radiance(), and the answer says " +
                std::to_string(estimate.samples) + " samples",
            "as many calls as samples, at most " + std::to_string(settings.max_samples)};
  }
  const Rgb right = mean_of(radiances);
  if (!is_mean(estimate.mean, right, radiances.size())) {
    return another_mean("returns_the_mean_of_all_samples", estimate.mean, right, radiances.size());
  }
  const auto stops = [&](const char* promise, const std::string& why) {
    return Explanation{Fault::structure, promise, std::to_string(taken) + " samples", why};
  };
  if (taken % settings.batch != 0 && taken != settings.max_samples) {
    return stops("checks_once_a_batch",
                 "a multiple of " + std::to_string(settings.batch) + ", or the maximum");
  }
  Spread spread;
  for (std::ptrdiff_t n = 1; n <= taken; ++n) {
    spread.add(luminance(radiances[n - 1]));
    if (n % settings.batch != 0) continue;
    const auto [must_stop, may_stop] = spread.condition(settings.tolerance);
    if (n < taken && must_stop) {
      return stops("stops_where_the_interval_is_narrow",
                   std::to_string(n) + ", after which the interval is narrow enough");
    }
    if (n == taken && n < settings.max_samples && !may_stop) {
      return stops("stops_where_the_interval_is_narrow", "more: the interval is still too wide");
    }
  }
  return {};
}

}  // namespace grader::explain
