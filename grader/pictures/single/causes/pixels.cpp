#include "grader/pictures/single/causes/suspects.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

template <class Do>
void for_neighbours(const pt::Image& image, std::size_t pixel, const Do& visit) {
  const int x = static_cast<int>(pixel % image.width), y = static_cast<int>(pixel / image.width);
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny) {
    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx) {
      visit(static_cast<std::size_t>(ny) * image.width + nx);
    }
  }
}

enum class Odd { no, bright, black };

// Compares a pixel with it and its neighbours in all of ours.
Odd oddness(const Suspects& suspects, const Codec& codec, const pt::Image& theirs,
            std::size_t pixel) {
  double least = pt::kInfinity, most = 0;
  for (const pt::Image& one : suspects.ours()) {
    for_neighbours(one, pixel, [&](std::size_t near) {
      const double value = luminance(one.pixels[near]);
      least = std::min(least, value);
      most = std::max(most, value);
    });
  }
  const double value = luminance(theirs.pixels[pixel]);
  if (codec.encode(value) == 0 && codec.encode(least) > 3) return Odd::black;
  return value > 3 * most + 0.05 ? Odd::bright : Odd::no;
}

pt::Rgb median_of_neighbours(const pt::Image& image, std::size_t pixel) {
  pt::Rgb out;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> values;
    for_neighbours(image, pixel,
                   [&](std::size_t near) { values.push_back(image.pixels[near][c]); });
    out[c] = pt::median_of(values);
  }
  return out;
}

// The signs of the steps from each pixel to its right neighbour in theirs less ours: noise alone, but at edges.
std::vector<int> signs_of_noise(const SingleVerdict& verdict) {
  const std::size_t count = verdict.theirs.pixels.size();
  std::vector<double> off(count);
  for (std::size_t i = 0; i < count; ++i) {
    off[i] = luminance(verdict.theirs.pixels[i]) - luminance(verdict.ours.pixels[i]);
  }
  std::vector<int> signs(count);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if ((i + 1) % verdict.theirs.width == 0) continue;
    signs[i] = (off[i] > off[i + 1] ? 1 : 0) - (off[i] < off[i + 1] ? 1 : 0);
  }
  return signs;
}

// The part of the pixels whose noise has the sign of the pixel (dx, dy) farther; .5 if few pixels can say it.
double equal_signs(const std::vector<int>& signs, int width, int height, int dx, int dy) {
  int equal = 0, all = 0;
  for (int y = 0; y + dy < height; ++y) {
    for (int x = std::max(0, -dx); x + std::max(dx, 0) < width; ++x) {
      const int a = signs[static_cast<std::size_t>(y) * width + x];
      const int b = signs[static_cast<std::size_t>(y + dy) * width + x + dx];
      all += std::abs(a * b);
      equal += a * b > 0 ? 1 : 0;
    }
  }
  return all < 500 ? 0.5 : static_cast<double>(equal) / all;
}

}  // namespace

void suspect_pixels(Suspects& suspects, const SingleVerdict& verdict) {
  SinglePicture changed = suspects.picture();
  const pt::Image before = changed.linear;
  std::size_t bright = 0, black = 0;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    const Odd odd = oddness(suspects, verdict.codec, verdict.theirs, i);
    if (odd == Odd::no) continue;
    ++(odd == Odd::bright ? bright : black);
    changed.linear.pixels[i] = median_of_neighbours(before, i);
  }
  if (bright + black == 0 || (bright + black) * 50 > before.pixels.size()) return;
  std::string words;
  if (bright > 0) words = fmt::format("{} single pixels are far too bright", bright);
  if (black > 0) {
    words += fmt::format("{}{} single pixels are black (NaN?)", bright > 0 ? " and " : "", black);
  }
  suspects.try_picture(words, changed);
}

std::string repeated_samples(const SingleVerdict& verdict) {
  const int width = verdict.theirs.width, height = verdict.theirs.height;
  constexpr int kFarthest = 32;
  constexpr double kRepeated = 0.75, kNotBeside = 0.62;
  const std::vector<int> signs = signs_of_noise(verdict);
  for (int dy = 0; dy <= std::min(kFarthest, height / 2); ++dy) {
    const int reach = std::min(kFarthest, width / 2);
    for (int dx = dy == 0 ? 2 : -reach; dx <= reach; ++dx) {
      const auto at = [&](int x, int y) { return equal_signs(signs, width, height, x, y); };
      // An error of the light leaves edges that are alike in pixels beside each other, too.
      if (at(dx, dy) < kRepeated || at(dx + 1, dy) > kNotBeside || at(dx - 1, dy) > kNotBeside ||
          at(dx, dy + 1) > kNotBeside) {
        continue;
      }
      return fmt::format(
          "each pixel has the noise of the one {} to the {} and {} below: the same random numbers",
          std::abs(dx), dx < 0 ? "left" : "right", dy);
    }
  }
  return "";
}

}  // namespace grader::pictures
