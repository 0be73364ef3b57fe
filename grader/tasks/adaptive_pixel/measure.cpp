#include "measure/calls/pixels.h"
#include "pt/tasks/adaptive_pixel.h"

namespace measure::calls {

Subject measure_adaptive_pixel(int of_case) {
  const auto draw = [view = view_of_pixels(of_case)](const Pixel& pixel, pt::Sampler& sampler) {
    constexpr pt::AdaptiveSettings kSettings{4096, 16, 0.05};
    const pt::PixelEstimate estimate =
        pt::adaptive_pixel(view, pixel.x, pixel.y, kSettings, sampler);
    return Estimate{luminance(estimate.mean), static_cast<double>(estimate.samples)};
  };
  return estimator_subject(pixels(), draw);
}

}  // namespace measure::calls
