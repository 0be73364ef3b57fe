#include "measure/calls/pixels.h"
#include "pt/tasks/estimate_pixel.h"

namespace measure::calls {

Subject measure_estimate_pixel(int of_case) {
  const auto draw = [view = view_of_pixels(of_case)](const Pixel& pixel, pt::Sampler& sampler) {
    constexpr int kSamples = 16;
    return Estimate{luminance(pt::estimate_pixel(view, pixel.x, pixel.y, kSamples, sampler)),
                    kSamples};
  };
  return estimator_subject(pixels(), draw);
}

}  // namespace measure::calls
