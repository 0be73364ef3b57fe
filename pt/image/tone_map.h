#pragma once

#include "pt/image/image.h"
#include "pt/image/picture.h"

#include <cmath>
#include <cstdint>

// Between linear radiance and the 8 bits of a screen: a pure power of 2.2, not the piecewise curve
// of sRGB (they differ by up to 8 of 255 in the shadows).

namespace pt {

inline constexpr double kGamma = 2.2;

// 255 clamp(exposure * linear)^(1/2.2), rounded. NaN becomes 0.
inline std::uint8_t encode(double linear, double exposure = 1) {
  const double value = exposure * linear;
  if (!(value > 0)) return 0;
  if (value >= 1) return 255;
  return static_cast<std::uint8_t>(std::lround(255 * std::pow(value, 1 / kGamma)));
}

// The middle of the values that encode() maps to `code`.
inline double decode(std::uint8_t code) { return std::pow(code / 255.0, kGamma); }

// The picture as a screen shows it.
Picture tone_map(const Image& image, double exposure = 1);

}  // namespace pt
