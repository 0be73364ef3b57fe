#include "pt/render/render_apart.h"

#include "pt/render/pixel_record.h"
#include "pt/render/radiance_apart.h"

#include <cmath>

namespace pt {

namespace {

constexpr double kPrecision = 1e-4;  // contracts let colors be of single precision

bool is_mean(Rgb mean, Rgb of_samples) {
  const Rgb off = mean - of_samples;
  const double size = std::abs(of_samples.r) + std::abs(of_samples.g) + std::abs(of_samples.b);
  return std::abs(off.r) + std::abs(off.g) + std::abs(off.b) <= kPrecision * size;
}

}  // namespace

PixelApart render_pixel_apart(const View& view, int x, int y, const RenderSettings& settings,
                              std::span<const BounceRange> ranges) {
  ApartRecord& record = apart_record();
  record.ranges.assign(ranges.begin(), ranges.end());
  record.moments.assign(ranges.size(), {});
  record.complete = true;
  const RenderedPixel whole = render_pixel(view, x, y, settings);
  record.ranges.clear();
  PixelApart apart;
  apart.not_finite = whole.not_finite;
  apart.complete = record.complete && is_mean(whole.pixel.mean, pixel_record().moments.mean());
  for (const RunningMoments& moments : record.moments) {
    apart.pixels.push_back(moments.pixel());
    apart.pixels.back().samples = whole.pixel.samples;
  }
  return apart;
}

}  // namespace pt
