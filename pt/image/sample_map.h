#pragma once

#include "pt/image/film.h"
#include "pt/image/picture.h"

#include <filesystem>
#include <vector>

namespace pt {

// The number of samples that each pixel of an adaptive render took. Row 0 is the TOP row.
struct SampleMap {
  int width = 0;
  int height = 0;
  std::vector<int> counts;  // width * height, row by row
  int max = 0;              // the most that the settings allow per pixel
};

SampleMap sample_map(const Film& film, int max);

// The colour of a count: dark blue for `min` samples, red for `max`, brighter with every step, so
// that it is also readable in grey and for the colour-blind.
Color8 sample_color(int count, int min, int max);

// The map in these colours, from its smallest count to map.max, with a legend of both below.
Picture sample_picture(const SampleMap& map);

// The raw counts as text, without a header: a line per row, the top row first, with commas between
// counts (for numpy.loadtxt(path, delimiter=',') or any spreadsheet). map.max is not written.
void write_counts(const std::filesystem::path& path, const SampleMap& map);

// Reads the text of write_counts; max becomes the largest count. Throws pt::Error, with the line,
// if the text is anything else.
SampleMap read_counts(const std::filesystem::path& path);

}  // namespace pt
