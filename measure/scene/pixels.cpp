#include "measure/scene/pixels.h"

#include "grader/base/parallel.h"
#include "measure/renders/rows.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace measure::scene {

namespace {

constexpr std::size_t kFirstPiece = 4, kLargestPiece = 2048;  // pixels per request

struct Cost {
  double cpu_seconds = 0;
  std::int64_t rays = 0;
};

pt::RowsRequest request_of(const pt::RenderSettings& settings,
                           std::span<const pt::BounceRange> ranges = {}) {
  return {0, 1, settings.samples, settings.adaptive, settings.seed, {ranges.begin(), ranges.end()},
          {}};
}

double luminance_of(const pt::Rgb& mean) { return is_finite(mean) ? luminance(mean) : 0; }

// Renders the pixels in pieces that take about as long as kQuick. take(first, rows) is called for each,
// one at a time.
template <class Take>
Cost in_pieces(const pt::View& view, const pt::RowsRequest& request,
               std::span<const PixelAt> pixels, int threads, const Take& take) {
  Cost cost;
  std::mutex mutex;
  std::size_t next = 0, piece = kFirstPiece;
  grader::base::for_each(threads, threads, [&](std::size_t) {
    pt::RowsRequest some = request;
    std::unique_lock lock(mutex);
    while (next < pixels.size()) {
      const std::size_t first = next, count = std::min(piece, pixels.size() - first);
      next += count;
      lock.unlock();
      some.only.clear();
      for (const PixelAt& at : pixels.subspan(first, count))
        some.only.push_back(at.y * view.width + at.x);
      const CostedRows made = costed_rows(view, some);
      lock.lock();
      take(first, made.rows);
      cost.cpu_seconds += made.cpu_seconds;
      cost.rays += made.rays;
      if (made.cpu_seconds < kQuick / 2) piece = std::min(2 * piece, kLargestPiece);
      if (made.cpu_seconds > kQuick) piece = std::max(piece / 2, kFirstPiece);
    }
  });
  return cost;
}

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

long long RenderedPixels::all_samples() const {
  return std::accumulate(samples.begin(), samples.end(), 0LL);
}

RenderedPixels measure(const pt::View& view, const pt::RenderSettings& settings,
                       std::span<const PixelAt> pixels) {
  RenderedPixels result{std::vector<double>(pixels.size()), std::vector<double>(pixels.size()),
                        std::vector<int>(pixels.size())};
  const auto take = [&](std::size_t first, const pt::PictureRows& rows) {
    for (std::size_t i = 0; i < rows.mean.size(); ++i) {
      result.mean[first + i] = luminance_of(rows.mean[i]);
      result.variance[first + i] = rows.measured.variance_y.at(i);
      result.samples[first + i] = rows.counts.empty() ? settings.samples : rows.counts[i];
    }
  };
  const Cost cost = in_pieces(view, request_of(settings), pixels, settings.threads, take);
  result.cpu_seconds = cost.cpu_seconds;
  result.rays = cost.rays;
  return result;
}

MeasuredApart measure_apart(const pt::View& view, const pt::RenderSettings& settings,
                            std::span<const pt::BounceRange> ranges,
                            std::span<const PixelAt> pixels) {
  MeasuredApart result;
  result.mean.assign(ranges.size(), std::vector<double>(pixels.size()));
  const auto take = [&](std::size_t first, const pt::PictureRows& rows) {
    if (!rows.measured.apart) {
      throw NotApart(
          "trace_path cannot be taken apart by bounces: they do not add up to what it returns; "
          "./run "
          "grade trace_path says what is wrong");
    }
    const std::size_t count = rows.mean.size() / ranges.size();
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      for (std::size_t i = 0; i < count; ++i)
        result.mean[k][first + i] = luminance_of(rows.mean[k * count + i]);
    }
  };
  result.cpu_seconds =
      in_pieces(view, request_of(settings, ranges), pixels, settings.threads, take).cpu_seconds;
  return result;
}

}  // namespace measure::scene
