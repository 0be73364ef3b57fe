#pragma once

#include "writeup/store.h"

#include <functional>

namespace writeup {

// A run of the program `accuracy`, for the worth of methods in a scene or the needs of the scene; of
// `view`, for the paths of a pixel; or of `stability` or `measure`, which have no scenes.
struct Measurement {
  std::string command;               // "cheapest", "converge", "stability", "measure" or "view"
  std::string scene;                 // path; empty without one
  std::vector<std::string> options;  // further words of the command line
  double seconds = 0;                // wall time that it may take, about
  const Code* code = nullptr;        // nothing: it is not in this build
  std::string depends;               // the part of the code that it depends on; empty: all of it
  std::string obstacle{};            // the reason why it cannot be made at all
};

// All measurements ever made, on disk: each in a folder whose name is a hash of everything that it depends on.
class Measurements {
 public:
  Measurements(std::filesystem::path folder, const Store& store);

  std::string key(const Measurement& measurement) const;
  // The folder of its files: charts, tables and, except for `measure`, <command>.json.
  std::filesystem::path folder(const Measurement& measurement) const;
  // The file that a measurement writes last.
  static std::string result_of(const Measurement& measurement) {
    return measurement.command + (measurement.command == "measure" ? ".csv" : ".json");
  }
  nlohmann::json load(const Measurement& measurement) const;

  bool is_complete(const Measurement& measurement) const;
  std::string failure(const Measurement& measurement) const;  // "" if there was none
  void fail(const Measurement& measurement, const std::string& reason) const;
  void forget_failure(const Measurement& measurement) const;
  bool is_settled(const Measurement& measurement) const {
    return is_complete(measurement) || !failure(measurement).empty();
  }

  // Seconds of processor time; the allowed time if it has not been made. A view is not timed.
  double cpu_seconds(const Measurement& measurement) const;

 private:
  std::filesystem::path folder_;
  const Store& store_;
};

// About how long make() takes for them.
double seconds_by_the_clock(const std::vector<Measurement>& all, int threads);

// Makes the measurements that are not settled, one after the other, each on this many threads: nothing
// else of the write-up runs at the same time. Only curves are made as many at a time as there are threads.
// If one has to be stopped, the rest is not tried.
void make(const Measurements& measurements, const std::vector<Measurement>& missing, int threads,
          const std::function<void(double)>& progress);

}  // namespace writeup
