#pragma once

#include "pt/geometry/ray.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/view.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

// The mock version of radiance() (pt/render/radiance.h) for the properties of estimate_pixel and
// adaptive_pixel. It returns the values of a script, and records its calls.

namespace grader::check {

struct RadianceCall {
  pt::Ray ray;
  pt::PathSettings settings;
  pt::Sampler::State sampler{};  // its state when radiance() was called
  long long lights = 0;          // of the scene
};

// The radiances that the mock version returns.
struct RadianceScript {
  // One after the other, and then the last one again; black if there are none. A worker gets them in
  // advance: it need not ask the judge at each call.
  std::vector<pt::Rgb> values{};
  // Instead of values, where the radiance depends on the ray or is not known in advance: that of call i
  // (from 0).
  std::function<pt::Rgb(int call, const pt::Ray& ray)> of_call{};
  // The count of numbers that each call draws from its sampler, as a path does.
  int numbers = 0;

  pt::Rgb at(std::size_t call) const {
    return values.empty() ? pt::Rgb{} : values[std::min(call, values.size() - 1)];
  }
};

// From now on, calls return what the script says. The calls so far are forgotten.
void script_radiance(RadianceScript script);

// The script, if there is one. It is defined here because programs with another radiance() ask too.
inline std::optional<RadianceScript>& radiance_script() {
  static std::optional<RadianceScript> current;
  return current;
}

// The calls since the last script_radiance().
const std::vector<RadianceCall>& radiance_calls();

}  // namespace grader::check
