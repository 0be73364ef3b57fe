#include "measure/renders/band.h"

#include "pt/error.h"
#include "pt/file.h"

#include <cstdio>

namespace measure {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BandEnd, missing, engine, primitives)

namespace {

constexpr std::size_t kMaxJson = std::size_t{1} << 24;

json read_json(const std::filesystem::path& file) {
  return json::parse(pt::read_file(file, kMaxJson));
}

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

}  // namespace measure
