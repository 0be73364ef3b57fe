#pragma once

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

}  // namespace measure::scene
