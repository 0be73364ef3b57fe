#include "tests/grader/pictures/synthetic_maps.h"

#include <algorithm>
#include <cmath>

namespace grader::pictures {
namespace {

struct Pixel {
  double deviation = 0;
  double brightness = 1;
};

// The samples so far: the sums that the rule uses, and the sums of the picture.
struct Entered {
  double n = 0, x = 0, xx = 0, total = 0;

  void add(double sample, StoppingRule rule) {
    total += sample;
    const double value = rule == StoppingRule::running_total ? total : sample;
    ++n;
    x += value;
    xx += value * value;
  }
};

bool narrow(const Entered& e, const pt::AdaptiveSettings& settings, StoppingRule rule) {
  const double mean = e.x / e.n;
  const double divisor = rule == StoppingRule::right_n ? e.n : e.n - 1;
  double variance = std::max(0.0, (e.xx - e.x * mean) / divisor);
  if (rule == StoppingRule::constant_goes_on && variance < 1e-12) variance = 1;
  // The sum of squares has a rounding error if all samples are equal.
  if (rule != StoppingRule::constant_goes_on && variance < 1e-12 * mean * mean) variance = 0;
  const double root = rule == StoppingRule::sigma_over_n ? e.n : std::sqrt(e.n);
  const double factor = rule == StoppingRule::no_1_96 ? 1 : 1.96;
  const double bound = settings.tolerance * (rule == StoppingRule::absolute ? 1 : mean);
  return factor * std::sqrt(variance) / root < bound;
}

pt::PixelEstimate estimate(const Pixel& pixel, const pt::AdaptiveSettings& settings,
                           StoppingRule rule, pt::Sampler& sampler) {
  Entered entered;
  const int batch = settings.batch;
  int n = 0;
  while (n < settings.max_samples) {
    const double e = -std::log(1 - sampler.next_1d());
    entered.add(pixel.brightness * (1 + pixel.deviation * (e - 1)), rule);
    ++n;
    const bool check = rule == StoppingRule::every_sample ? n >= batch : n % batch == 0;
    if (check && narrow(entered, settings, rule)) break;
  }
  const double mean = pixel.brightness == 0 ? 0 : entered.total / n;
  if (rule == StoppingRule::one_batch_short) n -= batch;
  return {pt::gray(mean), n};
}

}  // namespace

AdaptiveScene adaptive_scene(int width, int height) {
  AdaptiveScene scene{width, height, {}, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      const bool lamp = v < 0.1;
      scene.deviation.push_back(lamp ? 0 : 0.15 + 0.75 * u * (0.7 + 0.3 * std::sin(9 * v)));
      scene.black.push_back(v > 0.9 ? 1 : 0);
    }
  }
  return scene;
}

AdaptiveRun run_adaptive(const AdaptiveScene& scene, const pt::AdaptiveSettings& settings,
                         StoppingRule rule, double variance, std::uint64_t seed) {
  AdaptiveRun run{{scene.width, scene.height, {}, settings.max_samples},
                  pt::Image(scene.width, scene.height)};
  const double channel = rule == StoppingRule::one_channel ? 1.25 : 1;
  for (std::size_t i = 0; i < scene.deviation.size(); ++i) {
    pt::Sampler sampler = pt::Sampler::for_pixel(seed, static_cast<int>(i), 0);
    // The picture is darker than 1, so that a tolerance without the mean is another condition.
    const Pixel pixel{scene.deviation[i] * std::sqrt(variance * channel),
                      scene.black[i] ? 0.0 : 0.3};
    const pt::PixelEstimate found = estimate(pixel, settings, rule, sampler);
    run.map.counts.push_back(found.samples);
    run.picture.pixels[i] = found.mean;
  }
  return run;
}

SampleMapReference synthetic_reference(const AdaptiveScene& scene,
                                       const pt::AdaptiveSettings& settings) {
  std::vector<pt::SampleMap> maps;
  std::vector<pt::RunningMoments> sums(scene.deviation.size());
  for (std::uint64_t seed = 1; seed <= 64; ++seed) {
    const AdaptiveRun run = run_adaptive(scene, settings, StoppingRule::right, 1, seed);
    maps.push_back(run.map);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(run.picture.pixels[i]);
  }
  pt::Film picture(scene.width, scene.height);
  for (std::size_t i = 0; i < sums.size(); ++i) picture.pixels[i] = sums[i].pixel();
  return reference_of(maps, picture, settings);
}

}  // namespace grader::pictures
