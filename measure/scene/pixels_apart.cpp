#include "measure/scene/pixels_apart.h"

#include "measure/scene/timed.h"
#include "pt/error.h"
#include "pt/math/rgb.h"
#include "pt/render/render_apart.h"

namespace measure::scene {

MeasuredApart measure_apart(const pt::View& view, const pt::RenderSettings& settings,
                            std::span<const pt::BounceRange> ranges,
                            std::span<const PixelAt> pixels) {
  MeasuredApart result;
  result.mean.assign(ranges.size(), std::vector<double>(pixels.size()));
  result.cpu_seconds = timed(pixels.size(), settings.threads, [&](std::size_t i) {
    const pt::PixelApart apart =
        render_pixel_apart(view, pixels[i].x, pixels[i].y, settings, ranges);
    if (!apart.complete) {
      throw pt::Error(kNotApart);
    }
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      result.mean[k][i] = luminance(apart.pixels[k].mean);
    }
  });
  return result;
}

}  // namespace measure::scene
