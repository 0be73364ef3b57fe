#pragma once

#include "grader/check/property.h"
#include "grader/check/scenes.h"

// How noisy the usual methods are, found without the submission: in the judge's own process, by the
// framework's sample_light and by closed forms.

namespace grader::check {

// The largest deviation of an estimate of direct light by `samples` draws of each light, as the
// contract of direct_lights states it: one draw of a light deviates by twice what a draw of
// sample_light deviates, or by the mean of the light if that is more.
Noise noise_of_lights(const Situation& s, int samples);

// The largest deviation of the mean over `samples` uniform directions: no direction brings more
// than 2 albedo times the brightest radiance, and what lies in [0, b] with mean m has a variance of
// m (b - m) at most.
Noise noise_of_directions(const Situation& s, int samples);

}  // namespace grader::check
