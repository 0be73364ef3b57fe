#pragma once

#include "pt/math/rgb.h"
#include "pt/scene/bounce_range.h"
#include "pt/scene/recorder.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pt {

// Some rows of a picture, made by the linked tasks.
struct RowsRequest {
  int first_row = 0;  // as the tasks count: from the bottom
  int rows = 0;
  int samples = 1;                           // per pixel; unless adaptive
  std::optional<AdaptiveSettings> adaptive;  // adaptive_pixel in place of estimate_pixel
  std::uint64_t seed = 0;
  // For `measured`:
  std::vector<BounceRange> ranges{};  // a picture of each, from the same paths
  std::vector<int> only{};            // if not empty: these pixels alone, y * width + x, as one row
};

// The part of a result that only the implementation `measured` of render_rows fills in: a value per pixel, like the means.
struct RowsMeasured {
  std::vector<double> variance_y;  // of one sample's luminance
  std::vector<double> boxes;       // tested for the pixel; empty if there are ranges
  TestCount tests;                 // of all
  long long not_finite = 0;        // samples that are left out
  bool apart = true;               // false: the same paths cannot give all ranges
};

// A value per pixel, from left to right, row by row from the request's first row.
struct PictureRows {
  std::vector<Rgb> mean;    // as the task returned it, NaN included
  std::vector<int> counts;  // the samples that adaptive_pixel reports; else empty
  RowsMeasured measured;
};

// Renders the rows and returns the numbers; the judge compares them in another process. Each pixel
// has its own random numbers, from the seed and its position. There are two implementations:
//   plain     (pt/render/render_rows.cpp), for the grader;
//   measured  (pt/render/render_rows_measured.cpp), for the write-up: samples that are not finite
//             are left out of the mean, and each row has a picture per range, one after the other.
PictureRows render_rows(const View& view, const RowsRequest& request);

}  // namespace pt
