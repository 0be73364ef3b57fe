#pragma once

#include "pt/geometry/ray.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/view.h"

#include <cstdint>
#include <functional>
#include <vector>

// The mock version of radiance() (pt/render/radiance.h) for the properties of estimate_pixel and
// adaptive_pixel. It returns the values of a script, and records its calls.

namespace grader::check {

struct RadianceCall {
  pt::Ray ray;
  pt::PathSettings settings;
  pt::Sampler::State sampler{};  // its state when radiance() was called
};

// From now on, call i (from 0) returns script(i, ray). Each call draws `numbers` numbers from its
// sampler, as a path does. The calls so far are forgotten.
void script_radiance(std::function<pt::Rgb(int call, const pt::Ray& ray)> script, int numbers = 0);

// The calls since the last script_radiance().
const std::vector<RadianceCall>& radiance_calls();

}  // namespace grader::check
