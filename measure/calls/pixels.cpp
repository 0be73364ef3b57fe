// A known picture: the workers' radiance(), and the pixels of the picture.
#include "measure/calls/pixels.h"

#include "pt/render/radiance.h"

namespace measure::calls {

namespace {

constexpr int kSide = 8;  // of the picture, in pixels
constexpr double kDark = 0.1;

// The place on the window at distance 1 in front of the camera, which is a right angle wide and high.
double in_pixel(double along, double ahead) {
  const double at = 0.5 * kSide * (1 + along / ahead);
  return at - std::floor(at);
}

// Every pixel is bright to the left of a slanted line: at half its height the line is at kBright of its width. It does
// not pass through the centre, because some methods mirror their points about the centre.
constexpr double kLean = 0.37, kBright = 0.43;

}  // namespace

pt::View view_of_pixels(int of_case) {
  static const pt::Scene nothing;
  static pt::Camera camera;
  camera.hfov_deg = camera.vfov_deg = 90;
  pt::PathSettings settings;
  settings.to = of_case;  // read by radiance() below
  return {nothing, camera, settings, kSide, kSide};
}

std::vector<Pixel> pixels() {
  std::vector<Pixel> all;
  all.reserve(kPlaces);
  for (int i = 0; i < kPlaces; ++i) {
    all.push_back({i % kSide, i / kSide, kBright + kDark * (1 - kBright)});
  }
  return all;
}

}  // namespace measure::calls

// With bounces, the radiance is noisy: uniform from 0 to twice the mean.
pt::Rgb pt::radiance(const Scene&, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  using namespace measure::calls;
  const double x = in_pixel(ray.direction.x, -ray.direction.z);
  const double y = in_pixel(ray.direction.y, -ray.direction.z);
  const double value = x < kBright + kLean * (y - 0.5) ? 1 : kDark;
  return gray(settings.to > 0 ? 2 * value * sampler.next_1d() : value);
}
