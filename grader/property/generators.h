#pragma once

#include "pt/math/frame.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <rapidcheck.h>

// Random inputs that are of use for more than one task. RapidCheck has no generator of doubles in a
// range, so they are made from integers, which also shrink well: towards the middle of the range,
// and to few digits.

namespace grader {

// A multiple of (high - low) / 2^20 in [low, high]; shrinks towards the middle.
rc::Gen<double> real(double low, double high);

// Between low and high on a logarithmic scale, both > 0; shrinks towards the geometric mean.
rc::Gen<double> magnitude(double low, double high);

// Each component in [-size, size].
rc::Gen<pt::Vec3> point(double size = 10);

// A unit vector, all directions alike; shrinks towards an axis.
rc::Gen<pt::Vec3> direction();

// Three orthonormal axes, any rotation.
rc::Gen<pt::Frame> rotation();

// Each channel in [low, high], and different from the other two more often than not.
rc::Gen<pt::Rgb> color(double low = 0, double high = 1);

// A seed for a Sampler; does not shrink.
rc::Gen<std::uint64_t> sampler_seed();

}  // namespace grader
