#pragma once

#include "pt/image/film.h"
#include "pt/render/bounces_apart.h"

#include <span>
#include <vector>

namespace pt {

// The samples of the pixel that this thread renders, for several ranges of bounces at once. The
// implementation `apart` of radiance() fills it, from one path per sample; with no ranges it does
// what `recorded` does.
struct ApartRecord {
  std::vector<BounceRange> ranges;      // that are wanted
  std::vector<RunningMoments> moments;  // of each
  bool complete = true;                 // no sample whose bounces do not add up to it
};

ApartRecord& apart_record();

// The same bounces, cut wherever a range begins or ends; in order, without 0.
std::vector<BounceRange> pieces_of(std::span<const BounceRange> ranges);

}  // namespace pt
