#include "writeup/accuracy/pixels.h"

#include "grader/base/parallel.h"
#include "pt/error.h"
#include "pt/math/rgb.h"
#include "pt/render/cpu_time.h"
#include "pt/render/render_apart.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace writeup::accuracy {

namespace {

constexpr std::size_t kPiece = 64;  // pixels that one thread takes at a time

// Calls work(i) for every i < count on a few threads. Returns the processor time of all.
template <class Work>
double timed(std::size_t count, int threads, const Work& work) {
  double seconds = 0;
  std::mutex mutex;
  grader::base::for_each((count + kPiece - 1) / kPiece, threads, [&](std::size_t piece) {
    const double start = pt::thread_cpu_seconds();
    for (std::size_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i) work(i);
    const std::lock_guard lock(mutex);
    seconds += pt::thread_cpu_seconds() - start;
  });
  return seconds;
}

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

MeasuredApart measure_apart(const pt::View& view, const pt::RenderSettings& settings,
                            std::span<const pt::BounceRange> ranges,
                            std::span<const PixelAt> pixels) {
  MeasuredApart result;
  result.mean.assign(ranges.size(), std::vector<double>(pixels.size()));
  result.cpu_seconds = timed(pixels.size(), settings.threads, [&](std::size_t i) {
    const pt::PixelApart apart =
        render_pixel_apart(view, pixels[i].x, pixels[i].y, settings, ranges);
    if (!apart.complete) {
      throw pt::Error(
          "trace_path cannot be taken apart by bounces: they do not add up to what it returns; "
          "./run grade trace_path says what is wrong");
    }
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      result.mean[k][i] = luminance(apart.pixels[k].mean);
    }
  });
  return result;
}

}  // namespace writeup::accuracy
