#include "pt/render/render_film.h"

#include "pt/render/cpu_time.h"
#include "pt/render/pixel_record.h"
#include "pt/render/threads.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <mutex>
#include <utility>
#include <vector>

namespace pt {

namespace {

constexpr int kTileSize = 16;

PixelEstimate call_pixel_task(const View& view, int x, int y, const RenderSettings& settings,
                              Sampler& sampler) {
  if (settings.adaptive) return adaptive_pixel(view, x, y, *settings.adaptive, sampler);
  return {estimate_pixel(view, x, y, settings.samples, sampler), settings.samples};
}

bool comes_before(const BadPixel& a, const BadPixel& b) {
  return std::pair(a.y, a.x) < std::pair(b.y, b.x);
}

void note_bad(RenderResult& done, BadPixel pixel) {
  if (!done.first_bad || comes_before(pixel, *done.first_bad)) done.first_bad = pixel;
}

// The data that threads share: the tiles that none has taken, and how far the picture is.
struct Tiles {
  int columns, count;
  std::atomic<int> next{0};
  std::atomic<int> done{0};
  std::mutex reporting;

  Tiles(int width, int height)
      : columns((width + kTileSize - 1) / kTileSize),
        count(columns * ((height + kTileSize - 1) / kTileSize)) {}
};

// The results of one thread, except its pixels.
RenderResult render_tiles(const View& view, const PixelRender& pixel, Film& film, Tiles& tiles,
                          const std::function<void(double)>& progress,
                          const std::atomic<bool>* stop) {
  const RayCount rays_before = rays_traced();
  const TestCount tests_before = recorder.count;
  const double cpu_before = thread_cpu_seconds();
  const auto stopped = [stop] { return stop != nullptr && *stop; };
  RenderResult done;
  for (int tile = tiles.next++; tile < tiles.count && !stopped(); tile = tiles.next++) {
    const int x0 = tile % tiles.columns * kTileSize;
    const int y0 = tile / tiles.columns * kTileSize;
    for (int y = y0; y < std::min(y0 + kTileSize, view.height); ++y) {
      for (int x = x0; x < std::min(x0 + kTileSize, view.width); ++x) {
        if (stopped()) return done;
        const int row = view.height - 1 - y;
        const RenderedPixel rendered = pixel(x, y, film.at(x, row));
        film.set(x, row, rendered.pixel);
        if (rendered.not_finite == 0) continue;
        done.not_finite += rendered.not_finite;
        note_bad(done, {x, y});
      }
    }
    ++tiles.done;
    if (!progress) continue;
    const std::unique_lock lock(tiles.reporting, std::try_to_lock);
    if (lock.owns_lock()) progress(static_cast<double>(tiles.done) / tiles.count);
  }
  const RayCount rays = rays_traced();
  done.rays = {rays.closest - rays_before.closest, rays.occluded - rays_before.occluded};
  done.tests = {recorder.count.boxes - tests_before.boxes,
                recorder.count.triangles - tests_before.triangles,
                recorder.count.spheres - tests_before.spheres};
  done.cpu_seconds = thread_cpu_seconds() - cpu_before;
  return done;
}

}  // namespace

void add(RenderResult& result, const RenderResult& more) {
  result.rays.closest += more.rays.closest;
  result.rays.occluded += more.rays.occluded;
  result.tests.boxes += more.tests.boxes;
  result.tests.triangles += more.tests.triangles;
  result.tests.spheres += more.tests.spheres;
  result.not_finite += more.not_finite;
  result.seconds += more.seconds;
  result.cpu_seconds += more.cpu_seconds;
  if (more.first_bad && (!result.first_bad || comes_before(*more.first_bad, *result.first_bad))) {
    result.first_bad = more.first_bad;
  }
}

RenderedPixel render_pixel(const View& view, int x, int y, const RenderSettings& settings) {
  PixelRecord& record = pixel_record();
  record = {};
  Sampler sampler = Sampler::for_pixel(settings.seed, x, y);
  PixelEstimate estimate = call_pixel_task(view, x, y, settings, sampler);

  // The task counted samples that were not finite as black. They are removed from its mean.
  int not_finite = record.not_finite;
  if (not_finite > 0 && estimate.samples > not_finite) {
    estimate.mean *= static_cast<double>(estimate.samples) / (estimate.samples - not_finite);
  }
  if (!fits_float(estimate.mean)) {
    estimate.mean = {};
    ++not_finite;
  }
  const RunningMoments& moments = record.moments;
  return {{estimate.mean, moments.variance(), moments.variance_y(), estimate.samples}, not_finite};
}

RenderResult render_pixels(const View& view, Film film, int threads, const PixelRender& pixel,
                           const std::function<void(double)>& progress,
                           const std::atomic<bool>* stop) {
  const auto start = std::chrono::steady_clock::now();
  RenderResult result;
  result.film = std::move(film);
  Tiles tiles(view.width, view.height);
  std::vector<RenderResult> results(threads);
  in_threads(threads, [&](int i) noexcept {
    results[i] = render_tiles(view, pixel, result.film, tiles, progress, stop);
  });
  for (const RenderResult& done : results) add(result, done);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.complete = tiles.done == tiles.count;
  if (result.complete && progress) progress(1);
  return result;
}

RenderResult render_film(const View& view, const RenderSettings& settings,
                         const std::function<void(double)>& progress,
                         const std::atomic<bool>* stop) {
  assert((settings.adaptive || settings.samples > 0) && settings.threads > 0);
  const auto pixel = [&](int x, int y, const FilmPixel&) {
    return render_pixel(view, x, y, settings);
  };
  return render_pixels(view, Film(view.width, view.height), settings.threads, pixel, progress,
                       stop);
}

}  // namespace pt
