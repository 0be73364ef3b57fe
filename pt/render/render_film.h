#pragma once

#include "pt/image/film.h"
#include "pt/scene/recorder.h"
#include "pt/scene/scene.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace pt {

struct RenderSettings {
  int samples = 1;                           // per pixel; unless adaptive
  std::optional<AdaptiveSettings> adaptive;  // adaptive_pixel in place of estimate_pixel
  std::uint64_t seed = 0;
  int threads = 1;
};

// The pixel of a sample that was NaN or infinite, so that a person can look for the cause.
struct BadPixel {
  int x = 0;  // as the tasks count: from the left
  int y = 0;  // and from the bottom
};

struct RenderResult {
  Film film;
  RayCount rays;
  TestCount tests;
  long long not_finite = 0;           // samples left out of the picture
  std::optional<BadPixel> first_bad;  // the lowest, then leftmost, of the pixels they fell on
  double seconds = 0;                 // wall time
  double cpu_seconds = 0;             // of all threads
  bool complete = false;              // false if it was stopped before the end
};

// One pixel, (x, y) as the tasks count, and how many of its samples were not finite.
struct RenderedPixel {
  FilmPixel pixel;
  int not_finite = 0;
};
RenderedPixel render_pixel(const View& view, int x, int y, const RenderSettings& settings);

// Renders pixels, tile by tile, with any threads: `pixel` gets what `film` has of it and returns what
// it is then. One thread at a time calls `progress` now and then with the part done, in [0, 1]. Setting *stop ends the
// render within about a pixel.
using PixelRender = std::function<RenderedPixel(int x, int y, const FilmPixel& before)>;
RenderResult render_pixels(const View& view, Film film, int threads, const PixelRender& pixel,
                           const std::function<void(double)>& progress = {},
                           const std::atomic<bool>* stop = nullptr);

// Adds the rays, tests, bad samples and times of another result.
void add(RenderResult& result, const RenderResult& more);

// Renders the picture of a view, tile by tile. The same seed gives the same bits for any number of
// threads, because each pixel has its own random numbers.
RenderResult render_film(const View& view, const RenderSettings& settings,
                         const std::function<void(double)>& progress = {},
                         const std::atomic<bool>* stop = nullptr);

}  // namespace pt
