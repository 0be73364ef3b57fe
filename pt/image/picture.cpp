#include "pt/image/picture.h"

#include <algorithm>
#include <cmath>

#include <stb/stb_easy_font.h>

namespace pt {
namespace {

constexpr Color8 kGround{24, 24, 24};
constexpr Color8 kInk{255, 255, 255};
constexpr int kTextHeight = 9;  // dots, from the top of an ascender to below a descender

}  // namespace

Color8 ramp(std::span<const Color8> stops, double t) {
  assert(stops.size() >= 2);
  const int last = static_cast<int>(stops.size()) - 1;
  const double place = t > 0 ? std::min(t, 1.0) * last : 0;
  const int i = std::min(static_cast<int>(place), last - 1);
  Color8 color;
  for (int c = 0; c < 3; ++c) {
    color[c] = static_cast<std::uint8_t>(std::lround(std::lerp(
        static_cast<double>(stops[i][c]), static_cast<double>(stops[i + 1][c]), place - i)));
  }
  return color;
}

void draw_text(Picture& picture, int x, int y, int scale, const std::string& text, Color8 color) {
  struct Vertex {
    float x, y, z;
    std::uint8_t color[4];
  };
  struct Quad {
    Vertex corners[4];  // clockwise from the top left
  };
  std::vector<Quad> quads(32 * text.size() + 1);
  std::string copy = text;  // the library needs a text that is not const
  const int count = stb_easy_font_print(0, 0, copy.data(), nullptr, quads.data(),
                                        static_cast<int>(quads.size() * sizeof(Quad)));
  for (int i = 0; i < count; ++i) {
    const Vertex& low = quads[i].corners[0];
    const Vertex& high = quads[i].corners[2];
    const int x0 = std::max(0, x + scale * static_cast<int>(low.x));
    const int x1 = std::min(picture.width, x + scale * static_cast<int>(high.x));
    const int y0 = std::max(0, y + scale * static_cast<int>(low.y));
    const int y1 = std::min(picture.height, y + scale * static_cast<int>(high.y));
    for (int py = y0; py < y1; ++py) {
      for (int px = x0; px < x1; ++px) picture.at(px, py) = color;
    }
  }
}

int text_width(int scale, const std::string& text) {
  std::string copy = text;
  return scale * stb_easy_font_width(copy.data());
}

Picture with_legend(const Picture& picture, std::span<const Color8> stops, const Legend& legend) {
  const int scale = picture.width >= 800 ? 2 : 1;
  const int margin = 6 * scale;
  const int bar_height = 10 * scale;
  const int line = (kTextHeight + 3) * scale;
  const int labels = text_width(scale, legend.left) + text_width(scale, legend.middle) +
                     text_width(scale, legend.right) + 4 * margin;
  const int width =
      std::max({picture.width, labels + 2 * margin, text_width(scale, legend.title) + 2 * margin});
  Picture out(width, picture.height + bar_height + 2 * line + 2 * margin, kGround);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) out.at(x, y) = picture.at(x, y);
  }
  const int bar_width = width - 2 * margin;
  const int top = picture.height + margin;
  for (int x = 0; x < bar_width; ++x) {
    const Color8 color = ramp(stops, x / (bar_width - 1.0));
    for (int y = 0; y < bar_height; ++y) out.at(margin + x, top + y) = color;
  }
  const int text_top = top + bar_height + 3 * scale;
  const auto centred = [&](int y, const std::string& text) {
    draw_text(out, (width - text_width(scale, text)) / 2, y, scale, text, kInk);
  };
  draw_text(out, margin, text_top, scale, legend.left, kInk);
  centred(text_top, legend.middle);
  draw_text(out, width - margin - text_width(scale, legend.right), text_top, scale, legend.right,
            kInk);
  centred(text_top + line, legend.title);
  return out;
}

}  // namespace pt
