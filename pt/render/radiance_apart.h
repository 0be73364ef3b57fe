#pragma once

#include "pt/image/film.h"
#include "pt/render/bounces_apart.h"

#include <span>
#include <vector>

namespace pt {

// The samples of the pixel that this thread renders, for several ranges of bounces at once. The
// implementation `apart` of radiance() fills it, from one path per sample. Without ranges, `apart`
// does the same as `recorded`.
struct ApartRecord {
  std::vector<BounceRange> ranges;      // the requested ranges
  std::vector<RunningMoments> moments;  // of each
  bool complete = true;                 // the bounces of every sample add up to it
};

ApartRecord& apart_record();

// The same bounces in order, cut wherever a range begins or ends, without bounce 0.
std::vector<BounceRange> pieces_of(std::span<const BounceRange> ranges);

}  // namespace pt
