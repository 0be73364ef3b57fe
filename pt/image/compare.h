#pragma once

#include "pt/image/image.h"
#include "pt/image/picture.h"

#include <array>
#include <cstddef>
#include <vector>

// Compares a picture a with a picture b that is assumed to be right.

namespace pt {

// relMSE adds this part of the right picture's mean to its divisor: the errors of dark pixels stay bounded, and the
// error is the same for a scene and for the same scene under lamps ten times as bright.
inline constexpr double kDark = 0.04;
inline double dark_of(double mean) { return kDark * mean; }

// Results over all channels of the pixels that are finite in both pictures; 0 if there are none.
struct Comparison {
  double mse = 0;      // mean of (a - b)^2
  double rel_mse = 0;  // mean of (a - b)^2 / (|b| + dark)^2
  double dark = 0;     // dark_of the mean luminance of b
  Rgb mean_a, mean_b;
  // The largest |a - b|: x from the left, y from the top, channel 0 r, 1 g, 2 b.
  struct {
    int x = 0, y = 0, channel = 0;
    double a = 0, b = 0;
  } largest;
  std::size_t not_finite = 0;  // pixels, left out of all the above
};

// Throws pt::Error if the sizes differ.
Comparison compare(const Image& a, const Image& b);

// The errors of single pixels, the roots of these squares: half of the pixels have at most `median`,
// 99 of 100 at most `most`.
struct PixelErrors {
  double median = 0, most = 0, largest = 0;
};
PixelErrors pixel_errors(std::vector<double> squares);

// (a - b) / (|b| + dark), for pictures of a difference; 0 if they are equal.
double relative_difference(double a, double b, double dark);

// Blue where a is darker, orange where it is brighter, white where they agree; full at `full`, and
// black for NaN.
Color8 difference_color(double relative, double full = 0.2);

// The relative difference of the luminances in these colours, with the `dark` of the comparison;
// difference_picture adds a legend.
// They throw pt::Error if the sizes differ.
Picture difference_map(const Image& a, const Image& b);
Picture difference_picture(const Image& a, const Image& b);

}  // namespace pt
