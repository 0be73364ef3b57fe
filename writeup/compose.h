#pragma once

#include "pt/image/compare.h"
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

// The mean signed distance, in which noise vanishes: what a picture is too bright.
double bias(const Rendered& picture, const Rendered& golden);
// The noise of single pixels, from the picture's own variances.
pt::PixelErrors pixel_noise(const Rendered& picture, const Rendered& golden);
// The pixels in which the golden sees no light, and the samples that they took: parts of all.
struct Black {
  double pixels = 0, samples = 0;
};
Black on_black(const Rendered& picture, const Rendered& golden);

double mean_luminance(const pt::Film& film);
// The same over the pixels that see nothing but a lamp.
double mean_on_lamps(const pt::Film& film, const pt::Film& lamps);

// The samples per pixel that an adaptive render would take if it knew the variance.
std::vector<int> predicted_samples(const pt::Film& uniform, const pt::AdaptiveSettings& settings);

}  // namespace writeup
