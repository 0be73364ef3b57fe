#include "pt/image/compare.h"

#include "pt/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pt {
namespace {

// Blue and orange, because red and green look alike to some people. Both ends are equally bright.
constexpr std::array<Color8, 5> kDifferenceStops{
    {{8, 64, 150}, {90, 160, 225}, {255, 255, 255}, {245, 155, 60}, {165, 70, 0}}};

template <class Picture>
void check_sizes(const Picture& a, const Picture& b) {
  if (a.width == b.width && a.height == b.height) return;
  const auto size = [](const Picture& p) {
    return std::to_string(p.width) + " x " + std::to_string(p.height);
  };
  throw Error("the pictures cannot be compared: the first is " + size(a) + " pixels, the second " +
              size(b));
}

}  // namespace

double relative_difference(double a, double b, double dark) {
  return a == b ? 0 : (a - b) / (std::abs(b) + dark);
}

Comparison compare(const Image& a, const Image& b) {
  check_sizes(a, b);
  Comparison result;
  std::size_t count = 0;
  double largest = 0;
  const auto is_counted = [&](std::size_t i) {
    return is_finite(a.pixels[i]) && is_finite(b.pixels[i]);
  };
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (!is_counted(i)) continue;
    ++count;
    result.mean_a += a.pixels[i];
    result.mean_b += b.pixels[i];
  }
  result.not_finite = a.pixels.size() - count;
  if (count == 0) return result;
  result.mean_a /= static_cast<double>(count);
  result.mean_b /= static_cast<double>(count);
  result.dark = dark_of(luminance(result.mean_b));
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const Rgb pa = a.at(x, y), pb = b.at(x, y);
      if (!is_finite(pa) || !is_finite(pb)) continue;
      for (int c = 0; c < 3; ++c) {
        const double difference = pa[c] - pb[c];
        result.mse += difference * difference;
        if (difference == 0) continue;  // also where the right picture is black all over
        const double relative = difference / (std::abs(pb[c]) + result.dark);
        result.rel_mse += relative * relative;
        if (std::abs(difference) > largest) {
          largest = std::abs(difference);
          result.largest = {x, y, c, pa[c], pb[c]};
        }
      }
    }
  }
  result.mse /= 3.0 * static_cast<double>(count);
  result.rel_mse /= 3.0 * static_cast<double>(count);
  return result;
}

PixelErrors pixel_errors(std::vector<double> squares) {
  std::ranges::sort(squares);
  // Rounded up: with 99 % of a hundred pixels below, the largest is left out.
  const auto part = [&](double of_all) {
    const double rank = std::ceil(of_all * static_cast<double>(squares.size()));
    return std::sqrt(squares.at(static_cast<std::size_t>(std::max(rank, 1.0)) - 1));
  };
  return {part(.5), part(.99), part(1)};
}

Color8 difference_color(double relative, double full) {
  if (std::isnan(relative)) return {0, 0, 0};
  return ramp(kDifferenceStops, 0.5 + 0.5 * relative / full);
}

Picture difference_map(const Image& a, const Image& b) {
  const double dark = compare(a, b).dark;
  Picture picture(a.width, a.height);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    picture.pixels[i] =
        difference_color(relative_difference(luminance(a.pixels[i]), luminance(b.pixels[i]), dark));
  }
  return picture;
}

Picture difference_picture(const Image& a, const Image& b) {
  return with_legend(difference_map(a, b), kDifferenceStops,
                     {"-20 %", "0", "+20 %", "A below / above B"});
}

}  // namespace pt
