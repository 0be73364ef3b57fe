#pragma once

#include "grader/check/language/property.h"
#include "grader/check/scenes/scenes.h"

// The noise of the usual methods, found without the submission: in the judge's own process, with
// the framework's sample_light and with closed forms.

namespace grader::check {

// The largest deviation of an estimate of direct light with `samples` draws per light, by the
// contract of direct_lights. One draw of a light may deviate by twice the deviation of a draw of
// sample_light, or by the mean of the light if that is larger.
Noise noise_of_lights(const Situation& s, int samples);

// The largest deviation of the mean over `samples` uniform directions. No direction gives more than
// b, which is 2 albedo times the brightest radiance, and values in [0, b] with mean m have a
// variance of at most m (b - m).
Noise noise_of_directions(const Situation& s, int samples);

}  // namespace grader::check
