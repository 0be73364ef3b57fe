#include "pt/render/render_film.h"

#include "pt/render/cpu_time.h"
#include "pt/render/pixel_record.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <mutex>
#include <thread>
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

// The results of one thread, except its pixels.
struct ThreadResult {
  RayCount rays;
  TestCount tests;
  long long not_finite = 0;
  std::optional<BadPixel> first_bad;
  double cpu_seconds = 0;
};

bool comes_before(const BadPixel& a, const BadPixel& b) {
  return std::pair(a.y, a.x) < std::pair(b.y, b.x);
}

void note_bad(ThreadResult& done, BadPixel pixel) {
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

ThreadResult render_tiles(const View& view, const RenderSettings& settings, Film& film,
                          Tiles& tiles, const std::function<void(double)>& progress,
                          const std::atomic<bool>* stop) {
  const RayCount rays_before = rays_traced();
  const TestCount tests_before = recorder.count;
  const double cpu_before = thread_cpu_seconds();
  const auto stopped = [stop] { return stop != nullptr && *stop; };
  ThreadResult done;
  for (int tile = tiles.next++; tile < tiles.count && !stopped(); tile = tiles.next++) {
    const int x0 = tile % tiles.columns * kTileSize;
    const int y0 = tile / tiles.columns * kTileSize;
    for (int y = y0; y < std::min(y0 + kTileSize, view.height); ++y) {
      for (int x = x0; x < std::min(x0 + kTileSize, view.width); ++x) {
        if (stopped()) return done;
        const RenderedPixel rendered = render_pixel(view, x, y, settings);
        film.set(x, view.height - 1 - y, rendered.pixel);
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

void add(RenderResult& result, const ThreadResult& done) {
  result.rays.closest += done.rays.closest;
  result.rays.occluded += done.rays.occluded;
  result.tests.boxes += done.tests.boxes;
  result.tests.triangles += done.tests.triangles;
  result.tests.spheres += done.tests.spheres;
  result.not_finite += done.not_finite;
  result.cpu_seconds += done.cpu_seconds;
  if (done.first_bad && (!result.first_bad || comes_before(*done.first_bad, *result.first_bad))) {
    result.first_bad = done.first_bad;
  }
}

}  // namespace

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
  if (!is_finite(estimate.mean)) {
    estimate.mean = {};
    ++not_finite;
  }
  const RunningMoments& moments = record.moments;
  return {{estimate.mean, moments.variance(), moments.variance_y(), estimate.samples}, not_finite};
}

RenderResult render_film(const View& view, const RenderSettings& settings,
                         const std::function<void(double)>& progress,
                         const std::atomic<bool>* stop) {
  assert((settings.adaptive || settings.samples > 0) && settings.threads > 0);
  const auto start = std::chrono::steady_clock::now();
  RenderResult result;
  result.film = Film(view.width, view.height);
  Tiles tiles(view.width, view.height);
  std::vector<ThreadResult> results(settings.threads);
  {
    std::vector<std::jthread> threads;
    threads.reserve(results.size());
    for (ThreadResult& done : results) {
      threads.emplace_back([&, into = &done] {
        *into = render_tiles(view, settings, result.film, tiles, progress, stop);
      });
    }
  }
  for (const ThreadResult& done : results) add(result, done);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.complete = tiles.done == tiles.count;
  if (result.complete && progress) progress(1);
  return result;
}

}  // namespace pt
