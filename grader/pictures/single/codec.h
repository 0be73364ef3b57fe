#pragma once

#include "pt/image/image.h"

#include <array>
#include <string>
#include <vector>

// The way from radiance to the numbers of a file, which a picture has gone before it is judged. Our own renders go the same way and back, so that
// what rounding and clipping do to a mean is in both.

namespace grader::pictures {

enum class Curve { gamma, srgb, linear };

// 255 curve(clamp(exposure * linear)), rounded or cut off; or, without 8 bits, the number itself.
struct Codec {
  bool eight_bits = true;
  double exposure = 1;
  Curve curve = Curve::gamma;
  bool floor = false;

  int encode(double linear) const;   // 0 .. 255
  double decode(int code) const;     // the middle of what has this code
  double step(double linear) const;  // the width of a code there; 0 without 8 bits
  pt::Image through(const pt::Image& image) const;

  // "exposure 1.41, gamma 2.2, cut off to 8 bits"
  std::string words() const;
};

// The ways that programs go, each rounded or cut off. The exposures are those of this project and of the course.
std::vector<Codec> usual_codecs(const std::vector<double>& exposures,
                                const std::vector<Curve>& curves);
inline constexpr std::array kUsualExposures{1.0, 1.4142135623730951};

}  // namespace grader::pictures
