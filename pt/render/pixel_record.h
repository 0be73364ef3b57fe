#pragma once

#include "pt/image/film.h"

namespace pt {

// The statistics of all samples of the pixel that this thread renders, whatever task drew them. The
// picture's variance comes from here, and the mean from the task. The render loop empties it before
// each pixel; the implementations `recorded` and `apart` of radiance() fill it.
struct PixelRecord {
  RunningMoments moments;  // of the finite samples
  int not_finite = 0;      // NaN or infinite: left out of the picture
};

PixelRecord& pixel_record();

// Adds a sample. Returns it, or black if it is not finite.
Rgb recorded(Rgb sample);

}  // namespace pt
