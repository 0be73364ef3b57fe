#pragma once

#include "pt/image/image.h"
#include "pt/scene/view.h"

#include <string>
#include <vector>

namespace pt {

// A part of a picture: the pixels that show nothing but one sphere, one plane, or one curved surface. Pixels
// are indices into Image::pixels.
struct Region {
  std::string name;
  std::vector<int> pixels;
};

// The regions of a view. A plane or sphere is a region if it covers a hundredth of the picture; the rest is
// grouped by material. The last two are "edges", pixels that show several surfaces, and "picture".
std::vector<Region> find_regions(const View& view);

// Mean luminance.
double mean_over(const Region& region, const Image& image);

}  // namespace pt
