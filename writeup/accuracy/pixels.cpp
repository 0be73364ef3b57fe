#include "writeup/accuracy/pixels.h"

#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "writeup/accuracy/timed.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace writeup::accuracy {

namespace {

long long rays_so_far() { return pt::rays_traced().closest + pt::rays_traced().occluded; }

}  // namespace

std::vector<PixelAt> spread_pixels(int width, int height, int wanted, std::uint64_t seed) {
  const double all = static_cast<double>(width) * height;
  const int side = std::max(1, static_cast<int>(std::floor(std::sqrt(all / wanted))));
  pt::Sampler sampler(seed);
  std::vector<PixelAt> pixels;
  for (int y = 0; y < height; y += side) {
    for (int x = 0; x < width; x += side) {
      const int across = std::min(side, width - x), up = std::min(side, height - y);
      const auto [u, v] = sampler.next_2d();
      pixels.push_back({x + static_cast<int>(u * across), y + static_cast<int>(v * up)});
    }
  }
  return pixels;
}

long long Measured::all_samples() const {
  return std::accumulate(samples.begin(), samples.end(), 0LL);
}

Measured measure(const pt::View& view, const pt::RenderSettings& settings,
                 std::span<const PixelAt> pixels) {
  Measured result{std::vector<double>(pixels.size()), std::vector<double>(pixels.size()),
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

}  // namespace writeup::accuracy
