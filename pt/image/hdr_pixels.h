#pragma once

#include <string_view>

namespace pt {

// Returns whether a Radiance HDR picture has all of its pixels. stb_image takes zeros for what is missing, and where a
// file ends within the runs of a line it never comes to an end.
bool has_all_pixels(std::string_view hdr, int width, int height);

}  // namespace pt
