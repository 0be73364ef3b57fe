#pragma once

#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/bounce_range.h"
#include "pt/scene/scene.h"
#include "pt/scene/view.h"

#include <cmath>
#include <span>
#include <vector>

namespace pt {

// One estimate by any implementation of trace_path, split into ranges of bounces. trace_path runs
// once, while its hits and its direct light are recorded (pt/scene/recorder.h). Then it runs again for
// each range: the record answers in place of rays, and direct light of all other bounces is black. The
// result is what the range adds to the sum, because the sum is linear in direct light. This works where
// direct_lights and direct_hemisphere are linked in their recorded form.
struct BouncesApart {
  Rgb sum;                  // the result of trace_path
  std::vector<Rgb> ranges;  // the part of the sum that each range adds
  bool complete = false;    // the parts add up to the sum
};

// The sum of the absolute values of the channels.
inline double size_of(Rgb color) {
  return std::abs(color.r) + std::abs(color.g) + std::abs(color.b);
}

// Returns whether a difference of colors is as small as the errors of single precision, which
// contracts allow, for colors of this size.
inline bool is_rounding_error(Rgb difference, double size) {
  return size_of(difference) <= 1e-4 * size;
}

// Ranges do not overlap, and cover all bounces from 1 to settings.to; settings.from <= 1. The
// sampler ends in the state in which one call of trace_path leaves it.
BouncesApart trace_path_apart(const Scene& scene, const SurfacePoint& point,
                              const PathSettings& settings, std::span<const BounceRange> ranges,
                              Sampler& sampler);

// One estimate by any implementation of trace_path, with the part of every bounce: of `bounces`, entry i is what direct light
// of bounce i + 1 adds to the sum. `rest` is what the task returns without any direct light: black, unless it adds something
// else. While the path is walked for the first time, calls are kept as the recorder says.
struct PathParts {
  Rgb sum;
  std::vector<Rgb> bounces;
  Rgb rest;
};
PathParts trace_path_in_parts(const Scene& scene, const SurfacePoint& point,
                              const PathSettings& settings, Sampler& sampler);

}  // namespace pt
