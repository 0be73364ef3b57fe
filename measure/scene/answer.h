#pragma once

#include "measure/scene/options.h"
#include "measure/scene/study.h"

#include <optional>
#include <string>
#include <vector>

namespace measure::scene {

// A way that was tried, and its cheapest numbers of samples.
struct Option {
  Way way;
  std::vector<Tried> tried;
  SampleModel model;
  std::optional<Choice> choice;  // empty: it cannot reach the error
};

// Adaptive sampling compared with the same number of samples everywhere.
struct AdaptiveOption {
  pt::AdaptiveSettings settings;
  Checked checked;
  double times = 1;  // time over that of uniform sampling, at the same error
};

// The needs of one scene.
struct Answer {
  double error = 0;               // the requested error: root of relMSE
  std::vector<Uncertain> bias2;   // the bias^2 left with 0, 1, ... bounces
  std::vector<Option> survivals;  // all with the same bounces; first the course's survival
  std::vector<Option> bounces;    // other numbers of bounces
  Option hemisphere;              // without a choice if too inaccurate or not written
  Option course;                  // the settings of the course: 4 light samples, 5 bounces, .7
  Option best;
  Checked checked;  // of `best`
  std::optional<AdaptiveOption> adaptive;
  std::optional<Uncertain> without_tree;  // time over the usual; empty: too many surfaces
  std::vector<std::string> unwritten;     // unwritten tasks that some results need
  double smooth = 0;                      // the part of the pixels that smooth normals change
  double cpu_seconds = 0;                 // processor time of the study
  bool delta_lights = false;              // all lights are points or directions
};

bool is_unwritten(const Answer& answer, const std::string& task);

// Throws pt::Error if the error cannot be reached.
Answer find_cheapest(Study& study, const pt::View& view, const Options& options);

}  // namespace measure::scene
