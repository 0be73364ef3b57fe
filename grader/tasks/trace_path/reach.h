#pragma once

#include "grader/tasks/trace_path/estimates.h"

// The bounces that paths reach.

namespace grader::check::trace_path_inputs {

// If a sixth of all paths reach a bounce, some of them reach the next one, for any survival. For
// example, a path goes on with a chance of .04 (roulette by the throughput, from bounce 2 on in a
// room of albedo .2). Then 24 of 600 paths go on, and the probability that none does is 4e-11.
inline constexpr int kPaths = 600, kMany = 100;

// Many of kPaths paths reach the bounce `last`. Fewer reach the next one, `beyond`.
struct Reach {
  int last = 2, beyond = 0;
};

// Halves the range of bounces, beginning with the cap itself. `last` is the cap if many paths reach it.
inline Reach reach_of(const Case& c) {
  Reach reach{2, c.settings.to + 1};
  while (reach.beyond - reach.last > 1) {
    const int k = reach.beyond > c.settings.to ? c.settings.to : (reach.last + reach.beyond) / 2;
    (lit(c, k, kPaths) >= kMany ? reach.last : reach.beyond) = k;
  }
  return reach;
}

}  // namespace grader::check::trace_path_inputs
