#pragma once

#include "measure/scene/begin.h"
#include "measure/scene/ladder_rungs.h"

#include <string>
#include <vector>

namespace measure::scene {

// The measurements of a rung, as means per pixel.
struct RungTurns {
  std::vector<double> log_times;  // per turn: log of its time over the base's
  double seconds = 0;             // processor time of the base
  double samples = 0;
  double rays = 0;
  Uncertain variance;  // of the picture, relative
  Uncertain bias2;     // the square of the relative bias
};

// A rung of the ladder with its cost and its worth.
struct Climbed {
  Rung rung;
  double samples = 0;  // mean per pixel
  double rays = 0;
  double seconds = 0;
  Uncertain error2;  // relMSE
  Uncertain
      worth;  // time x relMSE of the last kept rung before this one, divided by that of this one
  Uncertain in_all;       // the same, for the lowest rung
  double worth_rays = 1;  // `worth` with rays instead of time
  double in_all_rays = 1;
  bool biased = false;       // its mean is not the picture's
  bool heavy_tails = false;  // the variance itself is uncertain
};

// The base is the first rung that is not `same_picture`. The rungs below were timed together with
// it, and have its noise. The rungs above were timed together with it too, but in other turns.
std::vector<Climbed> worth_of(const std::vector<Rung>& rungs, const std::vector<RungTurns>& turns);

struct Ladder {
  std::vector<Climbed> rungs;  // from the plainest up
  Chosen chosen;
};

// The part of the time for the long renders and for the choice of l and survival.
inline constexpr double kOfChoices = 0.35;

// Chooses settings, and measures all rungs. `command` is this program; the rungs' programs are next
// to it. Throws pt::Error if one of them is missing or ends.
Ladder climb(Measuring& scene, const Options& options, std::vector<std::string> command);

std::string to_text(const Ladder& ladder, const Options& options);

// Writes ladder.csv, and with gnuplot a chart.
void write_ladder(const Ladder& ladder, const std::filesystem::path& folder);

}  // namespace measure::scene
