#pragma once

#include "writeup/plan.h"

namespace writeup {

// A picture, its renders added up.
struct Composed {
  Rendered sum;
  int rows = 0;          // that are there, of every render
  bool complete = true;  // all of it is there
};

Composed compose(const Store& store, const std::vector<Unit>& units);

// The distance of a picture from one of many more samples, as a part of its brightness: the root of
// relMSE over the luminances.
double noise(const Rendered& picture);                          // by its own variance
double error(const Rendered& picture, const Rendered& golden);  // the golden's noise taken off

double mean_luminance(const pt::Film& film);

// The samples per pixel that an adaptive render would take if it knew the variance.
std::vector<int> predicted_samples(const pt::Film& uniform, const pt::AdaptiveSettings& settings);

}  // namespace writeup
