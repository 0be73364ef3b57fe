#pragma once

#include "pt/math/rgb.h"

#include <cassert>
#include <cstddef>
#include <vector>

namespace pt {

// A larger picture is treated as a mistake: 2^25 pixels, just above 8K.
inline constexpr int kMaxImageSide = 1 << 16;
inline constexpr long kMaxImagePixels = 1L << 25;

constexpr bool is_image_size(long width, long height) {
  return width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide &&
         width * height <= kMaxImagePixels;
}

// A picture in linear radiance. Row 0 is the TOP row, as in files; estimate_pixel and camera_ray
// count y from the bottom.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels;  // width * height, row by row

  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h) {}

  const Rgb& at(int x, int y) const { return pixels[index(x, y)]; }
  Rgb& at(int x, int y) { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return static_cast<std::size_t>(y) * width + x;
  }
};

}  // namespace pt
