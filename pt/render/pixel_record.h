#pragma once

#include "pt/image/film.h"

namespace pt {

// The statistics of all samples of the pixel that this thread renders, whatever task drew them. The
// picture's variance comes from here, and the mean from the task. The render loop empties it before
// each pixel; the implementations `recorded` and `apart` of radiance() fill it.
struct PixelRecord {
  RunningMoments moments;  // of the other samples
  int not_finite = 0;      // NaN, or above what a float holds: left out of the picture
};

// Returns whether a file of floats can hold the radiance as a finite one.
bool fits_float(Rgb radiance);

PixelRecord& pixel_record();

// Adds a sample. Returns it, or black if it does not fit a float.
Rgb recorded(Rgb sample);

}  // namespace pt
