#pragma once

#include "measure/scene/pixels.h"
#include "pt/scene/bounce_range.h"

#include <span>
#include <vector>

namespace measure::scene {

inline constexpr const char* kNotApart =
    "trace_path cannot be taken apart by bounces: they do not add up to what it returns; ./run "
    "grade trace_path says what is wrong";

// The mean of each pixel (inner) in each range of bounces (outer), from the same paths. Throws
// pt::Error if the linked trace_path cannot separate bounces.
struct MeasuredApart {
  std::vector<std::vector<double>> mean;
  double cpu_seconds = 0;
};
MeasuredApart measure_apart(const pt::View& view, const pt::RenderSettings& settings,
                            std::span<const pt::BounceRange> ranges,
                            std::span<const PixelAt> pixels);

}  // namespace measure::scene
