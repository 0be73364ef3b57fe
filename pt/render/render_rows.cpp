#include "pt/render/render_rows.h"

#include "pt/sampling/sampler.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

PictureRows render_rows(const View& view, const RowsRequest& request) {
  PictureRows result;
  for (int y = request.first_row; y < request.first_row + request.rows; ++y) {
    for (int x = 0; x < view.width; ++x) {
      Sampler sampler = Sampler::for_pixel(request.seed, x, y);
      if (request.adaptive) {
        const PixelEstimate estimate = adaptive_pixel(view, x, y, *request.adaptive, sampler);
        result.mean.push_back(estimate.mean);
        result.counts.push_back(estimate.samples);
      } else {
        result.mean.push_back(estimate_pixel(view, x, y, request.samples, sampler));
      }
    }
  }
  return result;
}

}  // namespace pt
