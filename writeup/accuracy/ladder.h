#pragma once

#include "writeup/accuracy/begin.h"
#include "writeup/accuracy/ladder_rungs.h"

#include <string>
#include <vector>

namespace writeup::accuracy {

// The measurements of a rung, per pixel in the mean.
struct RungTurns {
  std::vector<double> log_times;  // in each turn: log of its time over that of the base
  double seconds = 0;             // of processor time; of the base
  double samples = 0;
  double rays = 0;
  Uncertain variance;  // of the picture, relative
  Uncertain bias2;     // the square of the relative bias
};

// A rung of the ladder with what it costs and what it is worth.
struct Climbed {
  Rung rung;
  double samples = 0;  // of a pixel, in the mean
  double rays = 0;
  double seconds = 0;
  Uncertain error2;  // relMSE
  Uncertain
      worth;  // time x relMSE of the last kept rung before this one, divided by that of this one
  Uncertain in_all;       // the same of the lowest rung
  double worth_rays = 1;  // with rays in place of time
  double in_all_rays = 1;
  bool biased = false;       // its mean is not that of the picture
  bool heavy_tails = false;  // the variance itself is known badly
};

// The base is the first rung that is not `same_picture`. Those below it were timed beside it in
// turns of their own, and have its noise; those above, beside it too, in other turns.
std::vector<Climbed> worth_of(const std::vector<Rung>& rungs, const std::vector<RungTurns>& turns);

struct Ladder {
  std::vector<Climbed> rungs;  // from the plainest up
  Chosen chosen;
};

// The part of the time that the long renders and the choice of l and survival may take.
inline constexpr double kOfChoices = 0.35;

// Chooses settings, and measures all rungs. `programs`: the folder with those of the rungs. Throws
// pt::Error where one is missing or ends.
Ladder climb(Measuring& scene, const Options& options, const std::filesystem::path& programs);

std::string to_text(const Ladder& ladder, const Options& options);

// ladder.csv, and a chart where there is gnuplot.
void write_ladder(const Ladder& ladder, const std::filesystem::path& folder);

}  // namespace writeup::accuracy
