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

// The regions of a view, planes and spheres of their own from a hundredth of the picture on, the rest by material.
// The last two are "edges", the pixels that show more than one of them, and "picture", all.
std::vector<Region> find_regions(const View& view);

// Mean luminance.
double mean_over(const Region& region, const Image& image);

}  // namespace pt
