#include "measure/scene/print.h"

#include <cmath>

namespace measure::scene {

using nlohmann::json;

namespace {

json of(const Uncertain& number) { return {number.value, number.error}; }

json of(const Checked& checked, double pixels) {
  const pt::PixelErrors& errors = checked.pixel_errors;
  return {{"samples", checked.samples},
          {"seconds", checked.seconds * pixels},
          {"rays", checked.rays * pixels},
          {"error", of(checked.error)},
          {"bias", seen_bias(checked.bias2).value_or(0)},
          {"pixels", {errors.median, errors.most, errors.largest}},
          {"black_samples", checked.black_samples}};
}

json of(const Option& option, const Option& best, double pixels) {
  if (!option.choice) return nullptr;
  const Way& way = option.way;
  return {{"hemisphere", way.direct == pt::PathSettings::Direct::hemisphere},
          {"bounces", way.bounces},
          {"survival", way.survival},
          {"light_samples", option.choice->light_samples},
          {"samples", option.choice->samples},
          {"error", option.choice->error},
          {"seconds", option.choice->seconds * pixels},
          {"bias", std::sqrt(option.model.bias2)},
          {"times", of(times_as_long(option, best))}};
}

json of(const MethodCurve& curve, double pixels) {
  json points = json::array();
  for (const Checked& point : curve.points) points.push_back(of(point, pixels));
  return {{"id", curve.method.id},
          {"title", curve.method.title},
          {"adaptive", curve.method.adaptive},
          {"heavy_tails", curve.heavy_tails},
          {"fails", curve.fails},
          {"slope", of(curve.slope)},
          {"points", points}};
}

json of(const Factors& factors) {
  return {{"time", of(factors.time)}, {"error", of(factors.error)}, {"rays", of(factors.rays)}};
}

// The largest relative distance of a measured variance from the line A + B / l.
double off_the_line(const Option& option) {
  double most = 0;
  for (const Tried& tried : option.tried) {
    const double line = option.model.variance(tried.light_samples);
    most = std::max(most, std::abs(tried.variance.value / line - 1));
  }
  return most;
}

// The same for the times, c0 + c1 l.
double off_the_time_line(const Option& option) {
  double most = 0;
  for (const Tried& tried : option.tried) {
    const double line = option.model.seconds.at(tried.light_samples);
    most = std::max(most, std::abs(tried.seconds.value / line - 1));
  }
  return most;
}

}  // namespace

json to_json(const Answer& answer, int surfaces, double pixels) {
  const SampleModel& model = answer.survivals[0].model;
  const Uncertain& variance = cheapest_of(answer.best.tried).variance;
  json out{{"error", answer.error},
           {"surfaces", surfaces},
           {"pixels", pixels},
           {"cpu_seconds", answer.cpu_seconds},
           {"best", of(answer.best, answer.best, pixels)},
           {"checked", of(answer.checked, pixels)},
           {"known", variance.value > 0 ? variance.error / (2 * variance.value) : 0},
           {"a", model.noise.at_zero},
           {"b", model.noise.slope},
           {"c0", model.seconds.at_zero},
           {"c1", model.seconds.slope},
           {"off_the_line", off_the_line(answer.survivals[0])},
           {"off_the_time_line", off_the_time_line(answer.survivals[0])},
           {"best_light_samples", best_light_samples(model, kMaxLightSamples)},
           {"measured_light_samples", cheapest_of(answer.survivals[0].tried).light_samples},
           {"bias", json::array()},
           {"survivals", json::array()},
           {"hemisphere", of(answer.hemisphere, answer.best, pixels)},
           {"course", of(answer.course, answer.best, pixels)},
           {"course_bias", std::sqrt(answer.course.model.bias2)},
           {"smooth", answer.smooth},
           {"delta_lights", answer.delta_lights},
           {"unwritten", answer.unwritten},
           {"adaptive", nullptr},
           {"without_tree", nullptr}};
  for (const Uncertain& bias2 : answer.bias2) out["bias"].push_back(std::sqrt(bias2.value));
  for (const Option& option : answer.survivals) {
    out["survivals"].push_back(of(option, answer.best, pixels));
  }
  if (answer.adaptive) out["adaptive"] = of(answer.adaptive->times);
  if (answer.without_tree) out["without_tree"] = of(*answer.without_tree);
  return out;
}

json to_json(const std::vector<MethodCurve>& curves, double pixels, double cpu_seconds) {
  json all{{"pixels", pixels},
           {"cpu_seconds", cpu_seconds},
           {"fastest", fastest(curves).method.id},
           {"curves", json::array()}};
  for (const MethodCurve& curve : curves) {
    all["curves"].push_back(of(curve, pixels));
    for (const MethodCurve& other : curves) {
      if (curve.fails || other.fails) continue;
      all["curves"].back()["beside"][other.method.id] = of(factors(curve, other));
    }
  }
  return all;
}

}  // namespace measure::scene
