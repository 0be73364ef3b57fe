#include "grader/explain/explain.h"
#include "pt/geometry/spawn_ray.h"

#include <array>
#include <cstdio>

namespace grader::explain {

using pt::Rgb;
using pt::Vec3;

std::string brief(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string brief(Rgb c) {
  if (c.r == c.g && c.g == c.b) return brief(c.r);
  return "(" + brief(c.r) + ", " + brief(c.g) + ", " + brief(c.b) + ")";
}

namespace {

std::string count_of(int number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

// The error of a cosine by the contracts, and of one that a float computes from a rotated direction.
constexpr double kCosine = 3e-6;

constexpr const char* kSampler = "draws_from_the_sampler_alone";

// Shadow rays of many programs end a ten-thousandth of the way before the light. Far from the world's origin, the offset at their start moves
// them sideways, and a surface of the light, met at a small angle, may then hide the light. That can happen if the offset is longer than this part of the way.
constexpr double kCutOff = 5e-7;

// A call may draw so many numbers of its own, between those of its lights.
constexpr int kMostOwn = 100'000;

Explanation by_value(const char* promise, Rgb got, Rgb value, const std::string& of) {
  return {Fault::value, promise,
          brief(got),   "f L cos / pdf of the " + of + " of this call, which make " + brief(value),
          value,        got - value};
}

// Returns whether no direction can bring light: then no ray is needed.
bool is_dark(const pt::Scene& scene, const pt::SurfacePoint& point) {
  const bool glows = std::ranges::any_of(
      scene.materials, [](const pt::Material& m) { return !is_black(m.emission); });
  const bool has_sky = std::ranges::any_of(scene.lights, [](const pt::Light& light) {
    return std::holds_alternative<pt::AmbientLight>(light);
  });
  return is_black(point.albedo) || (!glows && !has_sky);
}

Rgb arriving(const pt::Scene& scene, const pt::Tracer& exact, const pt::SurfacePoint& point,
             const TracedRay& traced, Vec3 wi) {
  const pt::Ray right = spawn_ray(point, wi);
  const bool is_right = traced.ray.origin == right.origin && traced.ray.direction == wi &&
                        traced.ray.t_min == right.t_min && traced.ray.t_max == right.t_max;
  const auto hit = is_right ? traced.hit : exact.closest(scene.primitives, right);
  return hit ? surface_point(scene, right, *hit).emission : background(scene, wi);
}

// The sum over the draws of one light.
struct OfLight {
  Rgb sum;
  int draws = 0;
  bool is_lit = false;  // some draw brings light, or could
};

// Adds a draw to its light, and returns the error that its part may have.
double add_draw(const pt::Scene& scene, const pt::Tracer& exact, const pt::SurfacePoint& point,
                const pt::LightSample& sample, OfLight& light) {
  ++light.draws;
  const double cosine = dot(point.n, sample.wi);
  if (!(cosine > -kCosine) || is_black(sample.radiance)) return 0;
  light.is_lit = light.is_lit || cosine > 0;
  const Rgb part = (point.albedo / pt::kPi) * sample.radiance / sample.pdf;
  const double whole = max_channel(part) * std::max(cosine, kCosine);
  const pt::Ray shadow = shadow_ray(point, sample.wi, sample.distance);
  const bool is_hidden = exact.occluded(scene.primitives, shadow);
  if (!is_hidden && cosine > 0) light.sum += part * cosine;
  if (pt::kOffset * point.scale > kCutOff * sample.distance) return whole;
  return is_hidden ? 0 : kCosine * max_channel(part);
}

// Returns whether the light can bring light to the point. A light that is wholly below the horizon, or that turns its dark side
// to the point, need not be asked.
bool can_light(const pt::Light& light, const pt::SurfacePoint& point, const OfLight& found) {
  if (is_black(point.albedo)) return false;
  if (found.is_lit) return true;
  constexpr int kTried = 256;
  pt::Sampler sampler(1);
  for (int i = 0; i < kTried; ++i) {
    const pt::LightSample sample = sample_light(light, point.p, sampler);
    if (dot(point.n, sample.wi) > 0 && !is_black(sample.radiance)) return true;
  }
  return false;
}

std::string name_of(const pt::Light& light, int index) {
  constexpr std::array<const char*, 6> kNames{
      "a rectangle", "a ball", "a mesh", "a point light", "a directional light", "the sky"};
  return "light " + std::to_string(index + 1) + " (" + kNames[light.index()] + ")";
}

const char* promise_of(const pt::Scene& scene) {
  constexpr std::array<const char*, 6> kPromises{
      "matches_a_rectangle",         "matches_a_sphere",
      "matches_a_rectangle",         "matches_a_point_light",
      "matches_a_directional_light", "matches_the_sky"};
  return scene.lights.size() == 1 ? kPromises[scene.lights[0].index()] : "adds_the_lights_up";
}

}  // namespace

Explanation explain_sampler(const char* promise, const State& before, const State& after) {
  if (before != after) return {};
  return {Fault::structure, promise, "a call that leaves the sampler as it was before",
          "a sampler that has moved on by all numbers that were drawn"};
}

Explanation explain_hemisphere(const pt::Scene& scene, const pt::Tracer& exact,
                               const pt::SurfacePoint& point, int samples, const Told& told) {
  Rgb uniform, cosines;
  double more = 0;
  int rays = 0;
  for (const Event& event : told.events) {
    const auto* traced = std::get_if<TracedRay>(&event);
    if (traced == nullptr) continue;
    ++rays;
    const Vec3 wi = normalize(traced->ray.direction);
    const Rgb light = point.albedo * arriving(scene, exact, point, *traced, wi);
    const double cosine = dot(point.n, wi);
    if (cosine > 0) uniform += light * (2 * cosine);
    if (cosine > 0) cosines += light;
    more += 2 * kCosine * max_channel(light) / samples;
  }
  if (rays != samples && !(is_black(told.result) && is_dark(scene, point))) {
    return {Fault::structure, "takes_the_samples_asked_for",
            count_of(rays, "ray") + " of " + count_of(samples, "sample"),
            "one ray in a random direction per sample"};
  }
  if (rays > 0 && told.before == told.after)
    return explain_sampler(kSampler, told.before, told.after);
  uniform /= samples;
  cosines /= samples;
  for (const Rgb& value : {uniform, cosines}) {
    if (close(told.result, value, 1e-4, more)) return {};
  }
  return by_value("takes_the_emission_of_what_is_hit", told.result, uniform,
                  count_of(samples, "direction"));
}

Explanation explain_lights(const pt::Scene& scene, const pt::Tracer& exact,
                           const pt::SurfacePoint& point, int samples, const Told& told) {
  std::vector<OfLight> lights(scene.lights.size());
  double more = 0;
  State last = told.before;  // of the sampler, after the last draw
  const auto goes_on = [&](const State& state) {
    return numbers_between(last, state, kMostOwn) >= 0;
  };
  bool is_one_sampler = true;
  for (const Event& event : told.events) {
    const auto* draw = std::get_if<LightDraw>(&event);
    if (draw == nullptr) continue;
    if (draw->light < 0 || draw->light >= std::ssize(lights)) {
      return {Fault::value,
              "adds_the_lights_up",
              "a draw of a light that is not in the scene's list",
              "draws of the scene's own lights",
              {},
              told.result};
    }
    is_one_sampler = is_one_sampler && goes_on(draw->before);
    last = draw->after;
    const bool delta = is_delta(scene.lights[draw->light]);
    more +=
        add_draw(scene, exact, point, draw->sample, lights[draw->light]) / (delta ? 1 : samples);
  }
  Rgb sum;
  for (int i = 0; i < std::ssize(lights); ++i) {
    const OfLight& light = lights[i];
    const bool delta = is_delta(scene.lights[i]);
    const bool is_counted = delta ? light.draws > 0 : light.draws == samples;
    if (!is_counted && can_light(scene.lights[i], point, light)) {
      const int asked = delta ? 1 : samples;
      return {Fault::structure, "takes_the_samples_asked_for",
              count_of(light.draws, "draw") + " of " + name_of(scene.lights[i], i) + " for " +
                  count_of(samples, "sample"),
              count_of(asked, "draw") + " of each light that may bring light"};
    }
    if (light.draws > 0) sum += light.sum / light.draws;
  }
  if (last != told.before && told.before == told.after) {
    return explain_sampler(kSampler, told.before, told.after);
  }
  if (!is_one_sampler || !goes_on(told.after)) {
    return {Fault::structure, kSampler,
            "a draw with another sampler, or with numbers that were drawn before",
            "draws with the sampler of the call, each as the one before left it"};
  }
  if (close(told.result, sum, 1e-4, more)) return {};
  return by_value(promise_of(scene), told.result, sum, "draws");
}

}  // namespace grader::explain
