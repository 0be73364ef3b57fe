#pragma once

#include "pt/image/image.h"

#include <string>
#include <string_view>

// PFM, the plainest file of floats: "PF", width, height, a scale whose sign is the byte order, and then rows of 32-bit floats from
// the bottom up ("Pf" has one channel). Source: Debevec's description, netpbm's pfm(5).

namespace pt {

bool starts_as_pfm(std::string_view bytes);

// Throws pt::Error, with `name`, if the bytes are not a whole picture of an accepted size.
Image decode_pfm(std::string_view bytes, const std::string& name);

}  // namespace pt
