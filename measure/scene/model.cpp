#include "measure/scene/model.h"

#include <algorithm>
#include <cmath>

namespace measure::scene {

namespace {

double squares(const Line& line, std::span<const LinePoint> points) {
  double sum = 0;
  for (const LinePoint& point : points) {
    const double off = (line.at(point.x) - point.y) / point.error;
    sum += off * off;
  }
  return sum;
}

// Sums over the points, each with the weight 1 / error^2.
struct Sums {
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
};

Sums sums_of(std::span<const LinePoint> points) {
  Sums sums;
  for (const LinePoint& point : points) {
    const double weight = 1 / (point.error * point.error);
    sums.w += weight;
    sums.x += weight * point.x;
    sums.y += weight * point.y;
    sums.xx += weight * point.x * point.x;
    sums.xy += weight * point.x * point.y;
  }
  return sums;
}

FreeLine free_line(const Sums& s) {
  const double spread = s.w * s.xx - s.x * s.x;
  const double slope = (s.w * s.xy - s.x * s.y) / spread;
  return {{(s.y - slope * s.x) / s.w, slope}, std::sqrt(s.w / spread)};
}

}  // namespace

Uncertain price(const Tried& tried) {
  const double value = tried.variance.value * tried.seconds.value;
  return {value, std::hypot(tried.variance.error * tried.seconds.value,
                            tried.seconds.error * tried.variance.value)};
}

const Tried& cheapest_of(const std::vector<Tried>& tried) {
  return *std::ranges::min_element(tried, {}, [](const Tried& each) { return price(each).value; });
}

FreeLine fit_free_line(std::span<const LinePoint> points) { return free_line(sums_of(points)); }

Line fit_line(std::span<const LinePoint> points) {
  const Sums s = sums_of(points);
  const Line best = free_line(s).line;
  if (best.at_zero >= 0 && best.slope >= 0) return best;
  // Then one of the two numbers is zero: the one that does less harm.
  const Line flat{std::max(0.0, s.y / s.w), 0}, steep{0, std::max(0.0, s.xy / s.xx)};
  return squares(flat, points) < squares(steep, points) ? flat : steep;
}

double best_light_samples(const SampleModel& model, int most) {
  const double a_c1 = model.noise.at_zero * model.seconds.slope;
  const double b_c0 = model.noise.slope * model.seconds.at_zero;
  if (!(b_c0 > 0)) return 1;
  if (!(a_c1 > 0)) return most;
  return std::clamp(std::sqrt(b_c0 / a_c1), 1.0, static_cast<double>(most));
}

std::optional<int> worth_measuring(const std::vector<Tried>& tried, const SampleModel& model,
                                   double by) {
  std::optional<int> best;
  double least = (1 - by) * price(cheapest_of(tried)).value;
  for (int l = 1; l <= kMaxLightSamples; ++l) {
    if (std::ranges::any_of(tried, [&](const Tried& t) { return t.light_samples == l; })) continue;
    const double product = model.variance(l) * model.seconds.at(l);
    if (product < least) best = l;
    least = std::min(least, product);
  }
  return best;
}

std::optional<Choice> choice_with(const Tried& tried, double bias2, double error) {
  const double left = error * error - bias2;
  if (!(left > 0)) return std::nullopt;
  const double variance = tried.variance.value;
  const double samples = std::max(std::ceil(variance / left), double{kFewestSamples});
  if (!(samples <= kMaxSamples)) return std::nullopt;
  return Choice{tried.light_samples, static_cast<int>(samples),
                std::sqrt(variance / samples + bias2), samples * tried.seconds.value, variance};
}

std::optional<Choice> cheapest_choice(const std::vector<Tried>& tried, double bias2, double error) {
  std::optional<Choice> best;
  for (const Tried& each : tried) {
    const std::optional<Choice> choice = choice_with(each, bias2, error);
    if (choice && (!best || choice->seconds < best->seconds)) best = choice;
  }
  return best;
}

SampleModel model_of(const std::vector<Tried>& tried, double bias2) {
  std::vector<LinePoint> noise, seconds;
  for (const Tried& each : tried) {
    noise.push_back({1.0 / each.light_samples, each.variance.value,
                     std::max(each.variance.error, 1e-6 * each.variance.value + 1e-12)});
    seconds.push_back(
        {static_cast<double>(each.light_samples), each.seconds.value, each.seconds.error});
  }
  return {fit_line(noise), fit_line(seconds), bias2};
}

}  // namespace measure::scene
