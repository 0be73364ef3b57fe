// A picture that everybody knows: the slot radiance of the workers, and the two tasks that average it.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/estimate_pixel.h"
#include "writeup/measure/estimates.h"

namespace writeup::measure {

namespace {

constexpr int kSide = 8;  // of the picture, in pixels
constexpr int kSamples = 16;
constexpr pt::AdaptiveSettings kAdaptive{4096, 16, 0.05};
constexpr double kDark = 0.1;

struct Pixel {
  int x = 0, y = 0;
  double truth = 0;
};

// The place on the window at distance 1 in front of the camera, which is a right angle wide and high.
double in_pixel(double along, double ahead) {
  const double at = 0.5 * kSide * (1 + along / ahead);
  return at - std::floor(at);
}

// Every pixel is bright to the left of a slanted line: at half its height the line is at kBright of its width. It does
// not pass through the centre, because some methods mirror their points about the centre.
constexpr double kLean = 0.37, kBright = 0.43;

}  // namespace

Subject pixels(bool adaptive, int of_cases) {
  static const pt::Scene nothing;
  pt::Camera camera;
  camera.hfov_deg = camera.vfov_deg = 90;
  pt::PathSettings settings;
  settings.to = of_cases;  // for radiance() below
  std::vector<Pixel> all;
  all.reserve(kPlaces);
  for (int i = 0; i < kPlaces; ++i) {
    all.push_back({i % kSide, i / kSide, kBright + kDark * (1 - kBright)});
  }
  const pt::View view{nothing, camera, settings, kSide, kSide};
  return estimator_subject(all, [view, adaptive](const Pixel& pixel, pt::Sampler& sampler) {
    if (!adaptive) {
      return Estimate{luminance(estimate_pixel(view, pixel.x, pixel.y, kSamples, sampler)),
                      kSamples};
    }
    const pt::PixelEstimate estimate = adaptive_pixel(view, pixel.x, pixel.y, kAdaptive, sampler);
    return Estimate{luminance(estimate.mean), static_cast<double>(estimate.samples)};
  });
}

}  // namespace writeup::measure

// With bounces, the radiance is noisy: uniform from 0 to twice the mean.
pt::Rgb pt::radiance(const Scene&, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  using namespace writeup::measure;
  const double x = in_pixel(ray.direction.x, -ray.direction.z);
  const double y = in_pixel(ray.direction.y, -ray.direction.z);
  const double value = x < kBright + kLean * (y - 0.5) ? 1 : kDark;
  return gray(settings.to > 0 ? 2 * value * sampler.next_1d() : value);
}
