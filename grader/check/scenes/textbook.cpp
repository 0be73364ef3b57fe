#include "grader/check/scenes/textbook.h"

#include "grader/check/scenes/channels.h"
#include "pt/geometry/spawn_ray.h"

#include <algorithm>
#include <vector>

namespace grader::check {

using pt::Rgb;

namespace {

// The draws of one light. The noise of many lights is a sum, and so need not be known as well for each.
int draws_of_each(std::size_t lights) { return lights < 10 ? 1000 : 300; }

// Draws one sample of a light, and returns what it adds to the radiance of the point.
Rgb draw_of(const Situation& s, const pt::Light& light, pt::Sampler& sampler) {
  const pt::LightSample sample = pt::sample_light(light, s.point.p, sampler);
  const double cosine = dot(sample.wi, s.point.n);
  if (!(cosine > 0) || is_black(sample.radiance)) return {};
  const pt::Ray ray = pt::shadow_ray(s.point, sample.wi, sample.distance);
  if (s.scene.tracer.occluded(s.scene.primitives, ray)) return {};
  return s.point.albedo * sample.radiance * (cosine / sample.pdf / pt::kPi);
}

}  // namespace

Noise noise_of_lights(const Situation& s, int samples) {
  pt::Sampler sampler(17);
  Rgb variance;
  const int n = draws_of_each(s.scene.lights.size());
  for (const pt::Light& light : s.scene.lights) {
    if (is_delta(light)) continue;
    std::vector<Rgb> draws(n);
    for (Rgb& draw : draws) draw = draw_of(s, light, sampler);
    const Mean mean = mean_of(draws);
    const Rgb usual = squared(mean.standard_error) * n;
    variance += larger(4 * usual, squared(mean.value)) / samples;
  }
  return {square_root(variance)};
}

Noise noise_of_directions(const Situation& s, int samples) {
  const Rgb most = 2 * s.point.albedo * s.brightest;
  Rgb variance = s.expected * (most - s.expected);
  // Rounding errors may make it negative where everything is black.
  for (int channel = 0; channel < 3; ++channel)
    variance[channel] = std::max(0.0, variance[channel]);
  return {square_root(variance / samples)};
}

}  // namespace grader::check
