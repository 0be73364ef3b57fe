#pragma once

#include "pt/math/rgb.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pt {

// Some rows of a picture, as the tasks linked here make them.
struct RowsRequest {
  int first_row = 0;  // as the tasks count: from the bottom
  int rows = 0;
  int samples = 1;                           // per pixel; unless adaptive
  std::optional<AdaptiveSettings> adaptive;  // adaptive_pixel in place of estimate_pixel
  std::uint64_t seed = 0;
};

// A value per pixel, from the left, row by row from the request's first.
struct PictureRows {
  std::vector<Rgb> mean;    // as the task returned it, NaN included
  std::vector<int> counts;  // the samples that adaptive_pixel says it took; else empty
};

// Only the numbers: a grader judges them elsewhere. Each pixel has its own random
// numbers, from the seed and its place.
PictureRows render_rows(const View& view, const RowsRequest& request);

}  // namespace pt
