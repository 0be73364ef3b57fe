#pragma once

#include "writeup/accuracy/ladder.h"
#include "writeup/accuracy/rung_wire.h"

#include <functional>

namespace writeup::accuracy {

// A rung at work.
struct Worker {
  Rung rung;
  std::function<RungReply(const RungRequest&)> program;
  pt::RenderSettings settings;

  // Some pixels, with random numbers of their own.
  RungReply render(std::uint64_t seed, std::size_t first, std::size_t step) const;
};

// The state that all renders of a ladder share.
struct Turning {
  Study& study;
  std::uint64_t seed = 0;                // of the last render
  double seconds = 0;                    // of processor time that there is
  std::function<void(double)> progress;  // called with the part done
};

// Times engines beside the last of them: each turn is of other pixels, and all engines of a turn
// render the same with the same random numbers. As many pixels as there is time for.
std::vector<RungTurns> time_engines(const std::vector<Worker>& engines, Turning turning);

// Measures pictures: in each turn every worker renders the same pixels twice, one after the other.
// The base is the first. Half the square of the difference of two renders is the variance of one,
// whether the samples in it are independent or not.
std::vector<RungTurns> take_turns(const std::vector<Worker>& workers, Turning turning);

// time x variance of each worker's picture.
std::vector<double> costs_of(const std::vector<Worker>& workers, Turning turning);

}  // namespace writeup::accuracy
