#include "pt/render/render_apart.h"
#include "pt/render/render_film.h"
#include "pt/render/render_rows.h"

namespace pt {

namespace {

void add_row(const View& view, int y, const RowsRequest& request, PictureRows& result) {
  const RenderSettings settings{request.samples, request.adaptive, request.seed, 1};
  for (int x = 0; x < view.width; ++x) {
    const long long boxes = test_count.boxes;
    const RenderedPixel rendered = render_pixel(view, x, y, settings);
    result.mean.push_back(rendered.pixel.mean);
    if (request.adaptive) result.counts.push_back(rendered.pixel.samples);
    result.measured.variance_y.push_back(rendered.pixel.variance_y);
    result.measured.boxes.push_back(static_cast<double>(test_count.boxes - boxes));
    result.measured.not_finite += rendered.not_finite;
  }
}

void add_row_apart(const View& view, int y, const RowsRequest& request, PictureRows& result) {
  const RenderSettings settings{request.samples, {}, request.seed, 1};
  const std::size_t first = result.mean.size(), count = view.width * request.ranges.size();
  result.mean.resize(first + count);
  result.measured.variance_y.resize(first + count);
  for (int x = 0; x < view.width; ++x) {
    const PixelApart apart = render_pixel_apart(view, x, y, settings, request.ranges);
    result.measured.not_finite += apart.not_finite;
    result.measured.apart = result.measured.apart && apart.complete;
    for (std::size_t i = 0; i < request.ranges.size(); ++i) {
      const std::size_t at = first + i * view.width + x;
      result.mean[at] = apart.pixels[i].mean;
      result.measured.variance_y[at] = apart.pixels[i].variance_y;
    }
  }
}

}  // namespace

PictureRows render_rows(const View& view, const RowsRequest& request) {
  PictureRows result;
  const TestCount before = test_count;
  for (int y = request.first_row; y < request.first_row + request.rows; ++y) {
    if (request.ranges.empty()) {
      add_row(view, y, request, result);
    } else {
      add_row_apart(view, y, request, result);
    }
  }
  result.measured.tests = {test_count.boxes - before.boxes, test_count.triangles - before.triangles,
                           test_count.spheres - before.spheres};
  return result;
}

}  // namespace pt
