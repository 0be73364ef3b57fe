#include "writeup/store.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "measure/renders/spec.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr double kStart = 0.1;  // to start the program and read the scene
constexpr double kSecondsPerRay = 1.6e-7;
constexpr double kTreeSecondsPerRay = 4e-7;
constexpr double kHits = 0.75;          // the part of path rays that hit a surface
constexpr double kAdaptiveShare = 0.4;  // the part of the allowed samples

// Rays per camera sample: the camera ray, and for each bounce a path ray and its shadow rays.
double rays_per_sample(const pt::PathSettings& path) {
  if (path.show_normals) return 1;
  double rays = 1, survivors = 1;
  for (int bounce = 1; bounce <= path.to && survivors > 0.05; ++bounce) {
    if (bounce >= path.from) rays += survivors * path.light_samples;
    rays += survivors;
    survivors *= kHits * (bounce > 1 ? path.survival : 1);
  }
  return rays;
}

// Estimates the seconds on one processor of a render that was never made before.
double estimated_seconds(const measure::Spec& spec) {
  const double share = spec.adaptive ? kAdaptiveShare : 1;
  const double rays = share * spec.samples * spec.pixels() * rays_per_sample(spec.path);
  const bool wide = spec.engine == pt::Engine::wide;
  return kStart + rays * (wide ? kSecondsPerRay : kTreeSecondsPerRay);
}

constexpr std::size_t kMaxScene = std::size_t{1} << 31;
constexpr std::size_t kMaxStored = std::size_t{1} << 16;

std::string text_of(const fs::path& file) {
  return fs::exists(file) ? pt::read_file(file, kMaxStored) : "";
}

void add(measure::RowHead& sum, const measure::RowHead& more) {
  sum.cpu_seconds += more.cpu_seconds;
  sum.rays += more.rays;
  sum.boxes += more.boxes;
  sum.triangles += more.triangles;
  sum.spheres += more.spheres;
  sum.not_finite += more.not_finite;
}

// `first` is where in the row the picture begins.
void enter_row(Rendered& result, int y, const measure::Row& row, int first) {
  const int top = result.film.height - 1 - y;
  for (int x = 0; x < result.film.width; ++x) {
    const measure::RowPixel& from = row.pixels[first + x];
    const double variance = std::max(0.F, from.variance_y);
    result.film.set(x, top,
                    {{from.mean[0], from.mean[1], from.mean[2]}, {}, variance, from.samples});
    result.boxes[static_cast<std::size_t>(top) * result.film.width + x] = from.boxes;
    result.has_variance = result.has_variance || from.variance_y >= 0;
  }
  add(result.total, row.head);
}

}  // namespace

Store::Store(fs::path folder) : folder_(std::move(folder)) {
  fs::create_directories(folder_ / "hashes");
  fs::create_directories(folder_ / "times");
}

// Large files are read once, and again when their size or time has changed.
std::string Store::hash_of(const std::string& file) const {
  std::string& known = scene_hashes_[file];
  if (!known.empty()) return known;
  const fs::path kept = folder_ / "hashes" / grader::base::sha256(grader::base::stamp(file));
  known = text_of(kept);
  if (known.empty()) {
    known = grader::base::sha256(pt::read_file(file, kMaxScene));
    pt::write_file(kept, known);
  }
  return known;
}

std::string Store::scene_hash(const std::string& file) const {
  const std::lock_guard lock(mutex_);
  return hash_of(file);
}

std::string Store::key(const Unit& unit) const {
  nlohmann::json spec = to_json(unit.spec);
  spec.erase("scene");
  const std::lock_guard lock(mutex_);
  const std::string text = spec.dump() + hash_of(unit.spec.scene) + identity(*unit.code, unit.spec);
  std::string& key = keys_[text];
  if (key.empty()) key = grader::base::sha256(text).substr(0, 32);
  return key;
}

std::vector<measure::Band> Store::bands(const Unit& unit) const {
  const fs::path folder = this->folder(unit);
  const std::string count = text_of(folder / "bands");
  std::vector<measure::Band> bands;
  if (count.empty()) return bands;
  const int height = unit.spec.height, wanted = std::stoi(count);
  for (int i = 0; i < wanted; ++i) {
    const int first = height * i / wanted;
    bands.push_back({folder, first, height * (i + 1) / wanted - first});
  }
  return bands;
}

std::vector<measure::Band> Store::begin(const Unit& unit, int count) const {
  const fs::path folder = this->folder(unit);
  if (!fs::exists(folder / "bands")) {
    fs::create_directories(folder);
    pt::write_file(folder / "spec.json", to_json(unit.spec).dump());
    pt::write_file(folder / "bands", std::to_string(std::clamp(count, 1, unit.spec.height)));
  }
  return bands(unit);
}

bool Store::is_complete(const Unit& unit) const {
  const std::vector<measure::Band> all = bands(unit);
  return !all.empty() && std::all_of(all.begin(), all.end(), [](const measure::Band& band) {
    return fs::exists(band.done());
  });
}

std::string Store::failure(const Unit& unit) const {
  const std::string why = obstacle(*unit.code, unit.spec);
  return why.empty() ? text_of(folder(unit) / "failed") : why;
}

void Store::fail(const Unit& unit, const std::string& reason) const {
  pt::write_file(folder(unit) / "failed", reason);
}

void Store::forget_failure(const Unit& unit) const { fs::remove(folder(unit) / "failed"); }

Rendered Store::load(const Unit& unit) const {
  Rendered result;
  result.film = pt::Film(unit.spec.width, unit.spec.height);
  result.boxes.assign(result.film.pixels.size(), -1);
  result.failed = failure(unit);
  for (const measure::Band& band : bands(unit)) {
    int y = band.first_row;
    for (const measure::Row& row : measure::read_rows(band.file(), unit.spec.row_pixels())) {
      enter_row(result, y++, row, unit.range * unit.spec.width);
    }
    if (!fs::exists(band.done())) continue;
    const measure::BandEnd end = measure::read_end(band);
    result.engine = end.engine;
    result.primitives = end.primitives;
    for (const std::string& task : end.missing) {
      if (std::find(result.missing.begin(), result.missing.end(), task) == result.missing.end()) {
        result.missing.push_back(task);
      }
    }
  }
  result.seconds = result.total.cpu_seconds;
  return result;
}

fs::path Store::time_file(const Unit& unit) const {
  return folder_ / "times" / grader::base::sha256(to_json(unit.spec).dump()).substr(0, 32);
}

double Store::seconds(const Unit& unit) const {
  const std::string known = text_of(time_file(unit));
  return known.empty() ? estimated_seconds(unit.spec) : std::stod(known);
}

void Store::remember_seconds(const Unit& unit) const {
  pt::write_file(time_file(unit), std::to_string(load(unit).seconds));
}

}  // namespace writeup
