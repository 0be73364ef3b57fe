#pragma once

#include "grader/check/language/show.h"  // without it, drawn values are shown as "<???>"
#include "pt/math/frame.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <string>

#include <rapidcheck.h>

// Random inputs for more than one task. RapidCheck generates integers, but not doubles in a range.
// The generators here shrink towards simple values: the middle of a range, few digits, an axis.
//
// A property draws whole objects, so that a failure shows "Sphere around ..." and not bare numbers:
//
//   struct Case { pt::Sphere sphere; pt::Ray ray; };
//   void showValue(const Case& c, std::ostream& out) { show_lines(out, c.sphere, c.ray); }
//   rc::Gen<Case> aimed() { return rc::gen::exec([] { ... *real(0, 1) ... return Case{...}; }); }
//
// `Case` and showValue must be in the same namespace. A single number is drawn with a name (draw).

namespace grader::check {

// Any double in [low, high]; shrinks towards the middle, rounded to a digit, and to few decimals.
rc::Gen<double> real(double low, double high);

// A double between low and high, both > 0, on a logarithmic scale. Shrinks towards 1 (or the
// geometric mean if 1 is outside), powers of ten, and few digits.
rc::Gen<double> magnitude(double low, double high);

// An integer in low .. high, both included; shrinks towards low.
rc::Gen<int> whole(int low, int high);

// A point with each component in [-size, size].
rc::Gen<pt::Vec3> point(double size = 10);

// A unit vector, uniform over all directions; shrinks towards an axis.
rc::Gen<pt::Vec3> direction();

// Three orthonormal axes, any rotation; shrinks towards the world's axes.
rc::Gen<pt::Frame> rotation();

// The frames whose axes are those of the world, in any order and direction: 0 to 23.
inline constexpr int kAxisFrames = 24;
pt::Frame axis_frame(int number);

// One of them. Its numbers are exactly 0, 1 and -1.
rc::Gen<pt::Frame> rotation_of_axes();

// A colour with each channel in [low, high]. Each channel is usually different from the other two.
rc::Gen<pt::Rgb> color(double low = 0, double high = 1);

// The brightness of a light, by the contracts from 1e-4 to 1e6: often one of the ends.
rc::Gen<double> brightness();

// Channels of 0 or 1, at least one of them 1: the hues of pure and mixed lights, and white.
rc::Gen<pt::Rgb> hue();

// A seed for a Sampler; does not shrink.
rc::Gen<std::uint64_t> sampler_seed();

// A value that a failure shows as "name: value".
template <class T>
T draw(const std::string& name, const rc::Gen<T>& generator) {
  return *generator.as(name + ":");
}

}  // namespace grader::check
