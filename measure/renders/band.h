#pragma once

#include "measure/renders/rows.h"
#include "measure/renders/spec.h"

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

}  // namespace measure
