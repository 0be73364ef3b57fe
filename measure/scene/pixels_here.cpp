#include "measure/scene/pixels.h"
#include "measure/scene/timed.h"
#include "pt/math/rgb.h"
#include "pt/todo_list.h"

#include <atomic>

namespace measure::scene {

namespace {

long long rays_so_far() { return pt::rays_traced().closest + pt::rays_traced().occluded; }

}  // namespace

RenderedPixels measure(const pt::View& view, const pt::RenderSettings& settings,
                       std::span<const PixelAt> pixels) {
  RenderedPixels result{std::vector<double>(pixels.size()), std::vector<double>(pixels.size()),
                        std::vector<int>(pixels.size())};
  std::atomic<long long> rays = 0;
  result.cpu_seconds = timed(pixels.size(), settings.threads, [&](std::size_t i) {
    const long long before = rays_so_far();
    const pt::FilmPixel pixel = render_pixel(view, pixels[i].x, pixels[i].y, settings).pixel;
    result.mean[i] = luminance(pixel.mean);
    result.variance[i] = pixel.variance_y;
    result.samples[i] = pixel.samples;
    rays += rays_so_far() - before;
  });
  result.rays = rays;
  return result;
}

std::vector<std::string> unwritten_tasks() { return pt::todo_list(); }

}  // namespace measure::scene
