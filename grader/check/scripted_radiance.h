#pragma once

#include "pt/geometry/ray.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/view.h"

#include <cstdint>
#include <functional>
#include <vector>

// The slot radiance (pt/render/radiance.h) for the tests of estimate_pixel and adaptive_pixel: it
// returns what the test wrote down, and remembers what it was asked.

namespace grader::check {

struct RadianceCall {
  pt::Ray ray;
  pt::PathSettings settings;
  pt::Sampler::State sampler{};  // as it was when radiance was called
};

// From now on, call i (from 0) returns script(i, ray), and each call draws `numbers` numbers from
// its sampler, as a path does. Forgets the calls so far.
void script_radiance(std::function<pt::Rgb(int call, const pt::Ray& ray)> script, int numbers = 0);

// The calls since then.
const std::vector<RadianceCall>& radiance_calls();

}  // namespace grader::check
