#pragma once

#include "pt/image/accuracy.h"
#include "pt/image/compare.h"
#include "writeup/plan.h"

#include <optional>

namespace writeup {

// A picture, its renders added up.
struct Composed {
  Rendered sum;
  int rows = 0;          // the rows that every render has
  bool complete = true;  // no row is missing
};

Composed compose(const Store& store, const std::vector<Unit>& units);

// The pixels of a part. It has one at least.
Rendered cropped(const Rendered& whole, const Crop& crop);

// The figure's goldens, or a part of them; nothing if it has none, or if they are not made.
std::optional<pt::Goldens> goldens_of(const Plan& plan, const Figure& figure,
                                      const std::optional<Crop>& crop = {});

// The accuracy of a picture of as many pixels.
pt::Accuracy accuracy(const Rendered& picture, const pt::Goldens& goldens);

// The noise of single pixels, from the picture's own variances.
pt::PixelErrors pixel_noise(const Rendered& picture, const pt::Goldens& goldens);
// The pixels in which the goldens see no light, and the samples that they took: parts of all.
struct Black {
  double pixels = 0, samples = 0;
};
Black on_black(const Rendered& picture, const pt::Goldens& goldens);

double mean_luminance(const pt::Film& film);
// The same over the pixels that see nothing but a lamp.
double mean_on_lamps(const pt::Film& film, const pt::Film& lamps);

// The samples per pixel that an adaptive render would take if it knew the variance.
std::vector<int> predicted_samples(const pt::Film& uniform, const pt::AdaptiveSettings& settings);

}  // namespace writeup
