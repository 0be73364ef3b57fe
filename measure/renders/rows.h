#pragma once

#include "pt/image/film.h"

#include <cstdint>
#include <filesystem>
#include <vector>

// Rows of a render, from the program that renders them. The file grows by one row at a time, so
// that finished rows stay even if that program is ended. Rows count from the bottom, as in the
// tasks. `pixels` is the number of pixels in a row: the width of the picture, or of several
// pictures side by side (Spec::row_pixels()).

namespace measure {

struct RowPixel {
  float mean[3];
  float variance_y;  // variance of one sample's luminance; negative: unknown
  std::int32_t samples;
  float boxes;  // boxes tested by this pixel's rays; negative: unknown
};

struct RowHead {
  double cpu_seconds = 0;
  std::int64_t rays = 0, boxes = 0, triangles = 0, spheres = 0, not_finite = 0;
};

struct Row {
  RowHead head;
  std::vector<RowPixel> pixels;
};

// The number of whole rows in the file; 0 if it is not there.
int rows_in(const std::filesystem::path& file, int pixels);

// Cuts off a row that is incomplete. Throws pt::Error if it cannot.
void cut_to_rows(const std::filesystem::path& file, int pixels, int rows);

void append_row(const std::filesystem::path& file, const Row& row);
std::vector<Row> read_rows(const std::filesystem::path& file, int pixels);

}  // namespace measure
