#pragma once

#include "bench/against_cycles.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pt {

// The work before the first sample, in seconds of processor time.
struct StartTimes {
  std::string title;
  double scene = 0;  // until the scene was loaded, with Blender's own start
  double tree = 0;   // from then on, until rays could be traced
};

struct SceneReport {
  std::string scene;
  std::vector<Region> regions;
  std::vector<std::string> titles;  // of the contenders
  RendererComparison comparison;    // its goldens: ours, theirs
  std::vector<StartTimes> times;
  std::optional<std::vector<double>>
      by_formula;  // the luminance of the regions, where one is known
};

// Tables for the terminal.
std::string to_text(const SceneReport& report);

// Writes regions.csv and, for each scene, <scene>_error.csv, a chart <scene>.svg if gnuplot is installed, and the
// two long renders as <scene>_ours.exr and <scene>_cycles.exr. Throws Error if a file cannot be written.
void write_reports(const std::vector<SceneReport>& reports, const std::filesystem::path& folder);

}  // namespace pt
