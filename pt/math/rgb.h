#pragma once

#include <algorithm>
#include <cmath>

// Linear radiance, albedo or a light's power in three channels. It is not a Vec3, so that a colour
// is never added to a point.

namespace pt {

struct Rgb {
  double r = 0;
  double g = 0;
  double b = 0;

  // Channel 0 is r, 1 is g, 2 is b.
  constexpr double operator[](int channel) const { return channel == 0 ? r : channel == 1 ? g : b; }
  constexpr double& operator[](int channel) { return channel == 0 ? r : channel == 1 ? g : b; }

  constexpr bool operator==(const Rgb&) const = default;
};

constexpr Rgb gray(double value) { return {value, value, value}; }

constexpr Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator-(Rgb a, Rgb b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb operator*(Rgb a, double s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Rgb operator*(double s, Rgb a) { return a * s; }
constexpr Rgb operator/(Rgb a, double s) { return {a.r / s, a.g / s, a.b / s}; }
constexpr Rgb& operator+=(Rgb& a, Rgb b) { return a = a + b; }
constexpr Rgb& operator*=(Rgb& a, Rgb b) { return a = a * b; }
constexpr Rgb& operator*=(Rgb& a, double s) { return a = a * s; }
constexpr Rgb& operator/=(Rgb& a, double s) { return a = a / s; }

// The brightness that the eye sees, with the weights of Rec. 709, which sum to 1. The course calls
// it illuminance.
constexpr double luminance(Rgb c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

constexpr double max_channel(Rgb c) { return std::max({c.r, c.g, c.b}); }
constexpr bool is_black(Rgb c) { return c.r == 0 && c.g == 0 && c.b == 0; }

inline bool is_finite(Rgb c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

}  // namespace pt
