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
  int max = 0;              // allowed per pixel by the settings
};

SampleMap sample_map(const Film& film, int max);

// The colour of a count: dark blue for `min` samples, red for `max`, brighter all the way, so that
// it also reads in grey and for the colour-blind.
Color8 sample_color(int count, int min, int max);

// The map in these colours, from its smallest count to map.max, with a legend below that names
// both.
Picture sample_picture(const SampleMap& map);

// The raw counts as text: a line per row, the top row first, the counts separated by commas, no
// header (numpy.loadtxt(path, delimiter=','), or any spreadsheet). map.max is not kept.
void write_counts(const std::filesystem::path& path, const SampleMap& map);

// Reads what write_counts wrote; max becomes the largest count. Throws pt::Error, with the line,
// for anything else.
SampleMap read_counts(const std::filesystem::path& path);

}  // namespace pt
