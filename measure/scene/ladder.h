#pragma once

#include "measure/scene/begin.h"
#include "measure/scene/study.h"

#include <string>
#include <vector>

namespace measure::scene {

// A renderer: implementations and settings. It has one idea more than the last kept rung before it.
struct Rung {
  std::string idea;
  std::string mixture;  // as in ./run --from
  pt::Engine engine = pt::Engine::wide;
  Way way{};
  int light_samples = 1;
  bool adaptive = false;
  bool same_picture = false;  // as the next rung: only the time differs
  bool kept = true;           // the rungs above have the idea too
};

// The ways to sample lights, from the simplest way to the way with most ideas.
enum class LightIdea { none, more_samples, solid_angle, spread };

// Settings that the ladder takes from short renders of the scene.
struct Chosen {
  int bounces = 5;
  bool hemisphere = true;              // false: it would miss lights without a surface
  double survival = 1;                 // the cheapest chance to go on
  int light_samples = 1;               // the cheapest number above one; 1: more change nothing
  bool more_pay = false;               // it is cheaper than one
  bool rectangles = true;              // some light is a rectangle
  int spread_samples = 2;              // the cheapest number of evenly spread samples
  LightIdea lights = LightIdea::none;  // cheapest, never solid_angle alone; later ideas are dropped
};

// A rung for the lights that was tried before the ladder.
struct LightTried {
  LightIdea idea = LightIdea::none;
  int light_samples = 1;
  double cost = 0;  // time x variance
};

// Enters the cheapest ideas and numbers of samples of those that were tried; first stands `none`.
Chosen with_cheapest_lights(Chosen chosen, const std::vector<LightTried>& tried);

// The rung with these ideas for its lights.
Rung with_lights(Rung rung, LightIdea idea, const Chosen& chosen);

// The rungs, from below. Their programs are listed in measure/CMakeLists.txt.
std::vector<Rung> rungs_of(const Chosen& chosen);

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
void write_ladder(const Ladder& ladder, const Options& options);

}  // namespace measure::scene
