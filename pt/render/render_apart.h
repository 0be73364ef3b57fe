#pragma once

#include "pt/render/bounces_apart.h"
#include "pt/render/render_film.h"

#include <span>
#include <vector>

namespace pt {

// One pixel in several ranges of bounces, all from the same paths.
struct PixelApart {
  std::vector<FilmPixel> pixels;  // of each range
  int not_finite = 0;             // samples that are left out
  bool complete = true;           // if false, the linked tasks cannot be split by bounces
};

// For programs that link the implementation `apart` of radiance(). The view's bounces are those of
// all ranges together; settings are not adaptive. Each sample is split by its bounces. The result
// is complete only if the pixel's task returns the mean of the samples.
PixelApart render_pixel_apart(const View& view, int x, int y, const RenderSettings& settings,
                              std::span<const BounceRange> ranges);

}  // namespace pt
