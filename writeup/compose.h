#pragma once

#include "writeup/plan.h"

namespace writeup {

// A picture, its renders added up.
struct Composed {
  Rendered sum;
  int rows = 0;          // the rows that every render has
  bool complete = true;  // no row is missing
};

Composed compose(const Store& store, const std::vector<Unit>& units);

// The distance of a picture from a picture of many more samples, relative to its brightness: the
// root of relMSE over the luminances.
double noise(const Rendered& picture);                          // from its own variance
double error(const Rendered& picture, const Rendered& golden);  // without the golden's noise

double mean_luminance(const pt::Film& film);

// The samples per pixel that an adaptive render would take if it knew the variance.
std::vector<int> predicted_samples(const pt::Film& uniform, const pt::AdaptiveSettings& settings);

}  // namespace writeup
