#pragma once

#include "measure/renders/band.h"
#include "pt/image/film.h"
#include "writeup/code.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace writeup {

// A render by some code.
struct Unit {
  measure::Spec spec;
  const Code* code = nullptr;
  int range = 0;  // the place in the spec's ranges, if it has some
};

// The result of a render.
struct Rendered {
  pt::Film film;             // samples 0 where a row is missing; variances of luminance alone
  std::vector<float> boxes;  // per pixel, as the film; empty if not counted
  measure::RowHead total;
  bool has_variance = false;
  std::vector<std::string> missing;  // tasks that are not written yet
  std::string engine;
  int primitives = 0;
  std::string failed;  // the reason why it ended early; empty: it did not
  double seconds = 0;  // of processor time
};

// All renders ever made, on disk: each in a folder whose name is a hash of everything that it
// depends on. Safe from any thread.
class Store {
 public:
  explicit Store(std::filesystem::path folder);

  std::string key(const Unit& unit) const;
  std::filesystem::path folder(const Unit& unit) const { return folder_ / key(unit); }

  // A hash of the content of a scene file.
  std::string scene_hash(const std::string& file) const;

  // The render's bands: `count` bands of about equal size, or the bands with which it was begun.
  // Makes the folder.
  std::vector<measure::Band> begin(const Unit& unit, int count) const;

  bool is_complete(const Unit& unit) const;
  std::string failure(const Unit& unit) const;  // "" if there was none
  void fail(const Unit& unit, const std::string& reason) const;
  void forget_failure(const Unit& unit) const;
  // Returns whether it is complete, or has failed for good.
  bool is_settled(const Unit& unit) const { return is_complete(unit) || !failure(unit).empty(); }

  // The render, as far as it has been made.
  Rendered load(const Unit& unit) const;

  // Seconds of processor time; of a similar render if this one has not been made.
  double seconds(const Unit& unit) const;
  void remember_seconds(const Unit& unit) const;

 private:
  std::vector<measure::Band> bands(const Unit& unit) const;
  std::string hash_of(const std::string& file) const;
  std::filesystem::path time_file(const Unit& unit) const;

  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::string> scene_hashes_, keys_;
};

}  // namespace writeup
