#pragma once

#include "pt/image/film.h"

namespace pt {

// What the samples of the pixel that this thread is at had to say, whichever task asked for them:
// the picture's variance comes from here, and the mean from the task. The render loop empties it
// before each pixel; the implementation `recorded` of radiance() fills it.
struct PixelRecord {
  RunningMoments moments;  // of the finite samples
  int not_finite = 0;      // NaN or infinite: left out of the picture
};

PixelRecord& pixel_record();

}  // namespace pt
