#include "measure/renders/band.h"

#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace measure {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BandEnd, missing, engine, primitives)
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxJson = std::size_t{1} << 24;

json read_json(const std::filesystem::path& file) {
  return json::parse(pt::read_file(file, kMaxJson));
}

std::size_t row_bytes(int pixels) { return sizeof(RowHead) + pixels * sizeof(RowPixel); }

}  // namespace

Band band_of(const std::string& words) {
  const std::filesystem::path path = words;
  Band band{path.parent_path()};
  char rest = 0;
  if (std::sscanf(path.filename().c_str(), "%d+%d%c", &band.first_row, &band.rows, &rest) != 2) {
    throw pt::Error("'" + words + "' is not a band: write FOLDER/FIRST+ROWS");
  }
  return band;
}

int start_band(const Band& band, int pixels) {
  const int done = rows_in(band.file(), pixels);
  cut_to_rows(band.file(), pixels, done);
  return band.first_row + done;
}

void finish_band(const Band& band, const BandEnd& end) {
  pt::write_file(band.done(), json(end).dump());
}

BandEnd read_end(const Band& band) { return read_json(band.done()); }

Spec read_spec(const std::filesystem::path& file) { return spec_from_json(read_json(file)); }

int rows_in(const fs::path& file, int pixels) {
  std::error_code missing;
  const auto bytes = fs::file_size(file, missing);
  return missing ? 0 : static_cast<int>(bytes / row_bytes(pixels));
}

void cut_to_rows(const fs::path& file, int pixels, int rows) {
  if (!fs::exists(file)) return;
  std::error_code error;
  fs::resize_file(file, row_bytes(pixels) * std::min(rows, rows_in(file, pixels)), error);
  if (error) throw pt::Error(file.string() + " cannot be written: " + error.message());
}

void append_row(const fs::path& file, const Row& row) {
  std::vector<char> bytes(row_bytes(static_cast<int>(row.pixels.size())));
  std::memcpy(bytes.data(), &row.head, sizeof row.head);
  std::memcpy(bytes.data() + sizeof row.head, row.pixels.data(),
              row.pixels.size() * sizeof(RowPixel));
  std::ofstream out(file, std::ios::binary | std::ios::app);
  if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush()) {
    throw pt::Error(file.string() + " cannot be written: is the disk full?");
  }
}

std::vector<Row> read_rows(const fs::path& file, int pixels) {
  std::vector<Row> rows(rows_in(file, pixels));
  std::ifstream in(file, std::ios::binary);
  for (Row& row : rows) {
    row.pixels.resize(pixels);
    in.read(reinterpret_cast<char*>(&row.head), sizeof row.head);
    in.read(reinterpret_cast<char*>(row.pixels.data()),
            static_cast<std::streamsize>(pixels * sizeof(RowPixel)));
  }
  if (!rows.empty() && !in) throw pt::Error(file.string() + " cannot be read");
  return rows;
}

}  // namespace measure
