#include "pt/render/render_apart.h"
#include "pt/render/render_film.h"
#include "pt/render/render_rows.h"

#include <numeric>

namespace pt {

namespace {

// The pixels of one row, y * width + x.
std::vector<int> row_of(const View& view, int y) {
  std::vector<int> pixels(view.width);
  std::iota(pixels.begin(), pixels.end(), y * view.width);
  return pixels;
}

void add_row(const View& view, const std::vector<int>& pixels, const RowsRequest& request,
             PictureRows& result) {
  const RenderSettings settings{request.samples, request.adaptive, request.seed, 1};
  for (const int pixel : pixels) {
    const long long boxes = recorder.count.boxes;
    const RenderedPixel rendered =
        render_pixel(view, pixel % view.width, pixel / view.width, settings);
    result.mean.push_back(rendered.pixel.mean);
    if (request.adaptive) result.counts.push_back(rendered.pixel.samples);
    result.measured.variance_y.push_back(rendered.pixel.variance_y);
    result.measured.boxes.push_back(static_cast<double>(recorder.count.boxes - boxes));
    result.measured.not_finite += rendered.not_finite;
  }
}

void add_row_apart(const View& view, const std::vector<int>& pixels, const RowsRequest& request,
                   PictureRows& result) {
  const RenderSettings settings{request.samples, {}, request.seed, 1};
  const std::size_t first = result.mean.size(), count = pixels.size() * request.ranges.size();
  result.mean.resize(first + count);
  result.measured.variance_y.resize(first + count);
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const int x = pixels[k] % view.width, y = pixels[k] / view.width;
    const PixelApart apart = render_pixel_apart(view, x, y, settings, request.ranges);
    result.measured.not_finite += apart.not_finite;
    result.measured.apart = result.measured.apart && apart.complete;
    for (std::size_t i = 0; i < request.ranges.size(); ++i) {
      const std::size_t at = first + i * pixels.size() + k;
      result.mean[at] = apart.pixels[i].mean;
      result.measured.variance_y[at] = apart.pixels[i].variance_y;
    }
  }
}

}  // namespace

PictureRows render_rows(const View& view, const RowsRequest& request) {
  PictureRows result;
  const TestCount before = recorder.count;
  const auto add = [&](const std::vector<int>& pixels) {
    if (request.ranges.empty()) {
      add_row(view, pixels, request, result);
    } else {
      add_row_apart(view, pixels, request, result);
    }
  };
  if (!request.only.empty()) add(request.only);
  const int end = request.only.empty() ? request.first_row + request.rows : request.first_row;
  for (int y = request.first_row; y < end; ++y) add(row_of(view, y));
  result.measured.tests = {recorder.count.boxes - before.boxes,
                           recorder.count.triangles - before.triangles,
                           recorder.count.spheres - before.spheres};
  return result;
}

}  // namespace pt
