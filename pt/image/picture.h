#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pt {

// A colour for a screen: 8 bits each of r, g and b, gamma applied.
using Color8 = std::array<std::uint8_t, 3>;

// The picture in a PNG. Row 0 is the TOP row.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Color8> pixels;  // width * height, row by row

  Picture() = default;
  Picture(int w, int h, Color8 fill = {})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, fill) {}

  const Color8& at(int x, int y) const { return pixels[index(x, y)]; }
  Color8& at(int x, int y) { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return static_cast<std::size_t>(y) * width + x;
  }
};

// The colour at t in 0..1 on the straight lines between `stops` (at least two, evenly spaced). A t
// outside has the colour of the nearer end, and NaN has the first colour.
Color8 ramp(std::span<const Color8> stops, double t);

// The texts of a legend: at both ends and in the middle of its bar; `title` is below it.
struct Legend {
  std::string left, middle, right, title;
};

// Writes ASCII text with its top left corner at (x, y). Each dot of a letter is a square of side
// `scale`. Parts outside the picture are cut off.
void draw_text(Picture& picture, int x, int y, int scale, const std::string& text, Color8 color);
int text_width(int scale, const std::string& text);

// The picture in its full size, with a bar of the ramp and its legend below it on a dark ground.
// The result is higher than the picture, and wider where the legend needs it.
Picture with_legend(const Picture& picture, std::span<const Color8> stops, const Legend& legend);

}  // namespace pt
