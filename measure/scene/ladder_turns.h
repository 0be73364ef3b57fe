#pragma once

#include "measure/scene/ladder.h"
#include "measure/scene/rung.h"

#include <functional>

namespace measure::scene {

// A rung at work.
struct Worker {
  Rung rung;
  std::function<RungReply(const RungRequest&)> program;
  Spec spec;  // its numbers of samples

  // Some pixels, with random numbers of their own.
  RungReply render(std::uint64_t seed, std::size_t first, std::size_t step) const;
};

// The state that all renders of a ladder share.
struct Turning {
  Study& study;
  std::uint64_t seed = 0;                // of the last render
  double seconds = 0;                    // available processor time
  std::function<void(double)> progress;  // called with the part done
};

// Times engines relative to the last engine. Each turn has other pixels, as many as there is time
// for; in a turn all engines render the same pixels with the same random numbers.
std::vector<RungTurns> time_engines(const std::vector<Worker>& engines, Turning turning);

// Measures pictures: in each turn every worker renders the same pixels twice, one after the other.
// The base is the first. Half the squared difference of two renders is the variance of one, even if
// its samples are not independent.
std::vector<RungTurns> take_turns(const std::vector<Worker>& workers, Turning turning);

// time x variance of each worker's picture.
std::vector<double> costs_of(const std::vector<Worker>& workers, Turning turning);

}  // namespace measure::scene
