#pragma once

#include "writeup/accuracy/options.h"
#include "writeup/accuracy/study.h"

#include <optional>
#include <string>
#include <vector>

namespace writeup::accuracy {

// A way that was looked at, and the cheapest numbers of samples for it.
struct Option {
  Way way;
  std::vector<Tried> tried;
  SampleModel model;
  std::optional<Choice> choice;  // nothing: it cannot reach the error
};

// Adaptive sampling beside the same number of samples everywhere.
struct AdaptiveOption {
  pt::AdaptiveSettings settings;
  Checked checked;
  double times = 1;  // as long as uniform sampling, at the same error
};

// The needs of one scene.
struct Answer {
  double error = 0;               // that was asked for: root of relMSE
  std::vector<Uncertain> bias2;   // left with 0, 1, ... bounces
  std::vector<Option> survivals;  // the same number of bounces; at first the one of the course
  std::vector<Option> bounces;    // other numbers of bounces
  Option hemisphere;              // no choice: it cannot reach the error, or is not written
  Option course;                  // the settings of the course: 4 light samples, 5 bounces, .7
  Option best;
  Checked checked;  // best
  std::optional<AdaptiveOption> adaptive;
  std::optional<Uncertain> without_tree;  // times as long; nothing: there are too many surfaces
  std::vector<std::string> unwritten;     // tasks without which some of this is not known
  double smooth = 0;                      // part of the pixels that smooth normals change
  double cpu_seconds = 0;                 // of the study
  bool delta_lights = false;              // all lights are points or directions
};

bool is_unwritten(const Answer& answer, const std::string& task);

// Throws pt::Error where the error cannot be reached.
Answer find_cheapest(Study& study, const pt::View& view, const Options& options);

}  // namespace writeup::accuracy
