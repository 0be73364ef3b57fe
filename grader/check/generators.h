#pragma once

#include "grader/check/show.h"  // wherever values are drawn, or they are shown as "<???>"
#include "pt/math/frame.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <string>

#include <rapidcheck.h>

// Random inputs that are of use for more than one task. RapidCheck generates integers and no
// doubles in a range; what is here shrinks towards simple values: the middle of a range, few
// digits, an axis.
//
// A property draws whole values of the domain, so that a failure shows "Sphere around ..." and no
// bare numbers:
//
//   struct Case { pt::Sphere sphere; pt::Ray ray; };
//   void showValue(const Case& c, std::ostream& out) { show_lines(out, c.sphere, c.ray); }
//   rc::Gen<Case> aimed() { return rc::gen::exec([] { ... *real(0, 1) ... return Case{...}; }); }
//
// where `Case` and showValue stand in the same namespace. A lone number is drawn by its name.

namespace grader::check {

// Any double in [low, high]; shrinks towards the middle, and to few decimals.
rc::Gen<double> real(double low, double high);

// Between low and high on a logarithmic scale, both > 0; shrinks towards 1 (or the geometric mean,
// where 1 is outside), powers of ten, and few digits.
rc::Gen<double> magnitude(double low, double high);

// In low .. high, both included; shrinks towards low.
rc::Gen<int> whole(int low, int high);

// Each component in [-size, size].
rc::Gen<pt::Vec3> point(double size = 10);

// A unit vector, all directions alike; shrinks towards an axis.
rc::Gen<pt::Vec3> direction();

// Three orthonormal axes, any rotation; shrinks towards the world's axes.
rc::Gen<pt::Frame> rotation();

// Each channel in [low, high], and different from the other two more often than not.
rc::Gen<pt::Rgb> color(double low = 0, double high = 1);

// A seed for a Sampler; does not shrink.
rc::Gen<std::uint64_t> sampler_seed();

// A value that a failure shows as "name: value".
template <class T>
T draw(const std::string& name, const rc::Gen<T>& generator) {
  return *generator.as(name + ":");
}

}  // namespace grader::check
