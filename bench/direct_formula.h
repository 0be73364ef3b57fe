#pragma once

#include "bench/regions.h"
#include "pt/scene/view.h"

#include <optional>
#include <vector>

namespace pt {

// The mean luminance of each region of a view by direct light alone, by Lambert's formula for flat lights, without random
// numbers. Nothing where the formula does not apply: for more than one bounce, for lights that are not rectangles, and
// where something stands between a surface and a light (seen from the light's centre and near its corners).
std::optional<std::vector<double>> direct_by_formula(const View& view,
                                                     const std::vector<Region>& regions);

}  // namespace pt
