#pragma once

#include "pt/image/film.h"

#include <cstdint>
#include <filesystem>
#include <vector>

// Rows of a render on their way from the program that renders them: a file that grows by one row at
// a time, so that whatever ends that program, what it had finished is there and need not be made
// again. Rows count from the bottom, as the tasks do. `pixels` is how many there are in a row: the
// width of the picture, or of several, one beside the other (Spec::row_pixels()).

namespace writeup {

struct RowPixel {
  float mean[3];
  float variance_y;  // of one sample's luminance; negative: not known
  std::int32_t samples;
  float boxes;  // tested by this pixel's rays; negative: not known
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

}  // namespace writeup
