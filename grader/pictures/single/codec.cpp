#include "grader/pictures/single/codec.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

constexpr double kGamma = 2.2;

// IEC 61966-2-1.
double to_curve(double value, Curve curve) {
  if (curve == Curve::linear) return value;
  if (curve == Curve::gamma) return std::pow(value, 1 / kGamma);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

double from_curve(double value, Curve curve) {
  if (curve == Curve::linear) return value;
  if (curve == Curve::gamma) return std::pow(value, kGamma);
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

int Codec::encode(double linear) const {
  const double value = std::clamp(exposure * linear, 0.0, 1.0);
  if (!(value > 0)) return 0;
  return static_cast<int>(255 * to_curve(value, curve) + (floor ? 0 : 0.5));
}

double Codec::decode(int code) const {
  if (code == 0) return 0.25 * from_curve(0.5 / 255, curve) / exposure;
  const double middle = std::min(code + (floor ? 0.5 : 0.0), 255.0);
  return from_curve(middle / 255, curve) / exposure;
}

double Codec::step(double linear) const {
  if (!eight_bits) return 0;
  const int code = std::min(encode(linear), 254);
  return decode(code + 1) - decode(code);
}

pt::Image Codec::through(const pt::Image& image) const {
  if (!eight_bits) return image;
  // The smallest number that has each code: a search among them is faster than a power.
  std::array<double, 256> linear, first;
  for (int code = 0; code < 256; ++code) {
    linear[code] = decode(code);
    first[code] = from_curve((code - (floor ? 0 : 0.5)) / 255, curve) / exposure;
  }
  first[0] = -1;
  pt::Image back(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto above = std::ranges::upper_bound(first, std::max(image.pixels[i][c], 0.0));
      back.pixels[i][c] = linear[above - first.begin() - 1];
    }
  }
  return back;
}

std::string Codec::words() const {
  if (!eight_bits) return "linear floats";
  const char* name = curve == Curve::gamma  ? "gamma 2.2"
                     : curve == Curve::srgb ? "sRGB"
                                            : "no gamma";
  return fmt::format("exposure {:.3g}, {}, {} to 8 bits", exposure, name,
                     floor ? "cut off" : "rounded");
}

std::vector<Codec> usual_codecs(const std::vector<double>& exposures,
                                const std::vector<Curve>& curves) {
  std::vector<Codec> all;
  for (const double exposure : exposures) {
    for (const Curve curve : curves) {
      for (const bool floor : {false, true}) all.push_back({true, exposure, curve, floor});
    }
  }
  return all;
}

}  // namespace grader::pictures
