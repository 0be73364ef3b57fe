#pragma once

#include "measure/renders/spec.h"
#include "pt/image/film.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// Part of a render: some rows from one process.

namespace measure {

struct Band {
  std::filesystem::path folder;  // of the render
  int first_row = 0, rows = 0;

  std::string name() const { return std::to_string(first_row) + "+" + std::to_string(rows); }
  std::filesystem::path file() const { return folder / (name() + ".rows"); }
  std::filesystem::path done() const { return folder / (name() + ".json"); }
};

// Reads "FOLDER/FIRST+ROWS". Throws pt::Error.
Band band_of(const std::string& words);

// The end of a band's file, written when all its rows are there.
struct BandEnd {
  std::vector<std::string> missing;  // tasks that are not written yet
  std::string engine;
  int primitives = 0;
};

// The first missing row. Cuts off an incomplete row in the file.
int start_band(const Band& band, int pixels);
void finish_band(const Band& band, const BandEnd& end);
BandEnd read_end(const Band& band);

Spec read_spec(const std::filesystem::path& file);

// Renders the rows of the band that its file does not have yet.
void make_band(const std::string& spec_file, const Band& band);

// Rows of a render, from the program that renders them. The file grows by one row at a time, so
// that finished rows stay even if that program is ended. Rows count from the bottom, as in the
// tasks. `pixels` is the number of pixels in a row: the width of the picture, or of several
// pictures side by side (Spec::row_pixels()).

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
