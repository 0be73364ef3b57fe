#pragma once

#include "measure/scene/options.h"
#include "measure/scene/study.h"
#include "pt/error.h"

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
  Uncertain times;           // time over that of uniform sampling, at the same error
  pt::PixelErrors uniform;   // with the same number of samples in every pixel
  double best_possible = 1;  // samples over those of uniform sampling, by the best rule there is
};

// The way with its model, and the cheapest numbers of samples that were measured.
Option option_of(const Way& way, std::vector<Tried> tried, double bias2, double error);

// The cheapest of `best` and the others. An option without a choice is dearer than any.
Option cheapest_of(const std::vector<Option>& others, Option best);

// The time of an option over that of the best, at the same error. Both have a choice.
Uncertain times_as_long(const Option& option, const Option& best);

// Throws pt::Error, which tells what the error would take, if that is more than can be had.
void expect_reachable(const Tried& tried, double error, double pixels);

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
  std::vector<std::string> wrong;         // what more samples would not mend, beside the reference
  double smooth = 0;                      // the part of the pixels that smooth normals change
  double cpu_seconds = 0;                 // processor time of the study
  bool delta_lights = false;              // all lights are points or directions
};

bool is_unwritten(const Answer& answer, const std::string& task);

// No way reaches the error, because the code is wrong beside the reference.
struct WrongBesideReference : pt::Error {
  using pt::Error::Error;
};

// Throws pt::Error if the error cannot be reached.
Answer find_cheapest(Study& study, const pt::View& view, const Options& options);

}  // namespace measure::scene
