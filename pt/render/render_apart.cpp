#include "pt/render/render_apart.h"

#include "pt/render/pixel_record.h"
#include "pt/render/radiance_apart.h"

namespace pt {

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
  const Rgb of_samples = pixel_record().moments.mean();
  apart.complete =
      record.complete && is_rounding_error(whole.pixel.mean - of_samples, size_of(of_samples));
  for (const RunningMoments& moments : record.moments) {
    apart.pixels.push_back(moments.pixel());
    apart.pixels.back().samples = whole.pixel.samples;
  }
  return apart;
}

}  // namespace pt
