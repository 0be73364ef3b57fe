#pragma once

#include "grader/explain/record.h"
#include "pt/scene/path_settings.h"
#include "pt/tasks/adaptive_pixel.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

// One call of a random task, held against the formula of its contract. No mean is needed: the record of the call says which
// random choices it made, and the formula says what they amount to. A call whose result, numbers of rays and draws, end and
// sampler all follow from its record is explained.

namespace grader::explain {

enum class Fault {
  none,
  structure,  // rays, draws, an end or the sampler: this one call breaks a promise
  habit,      // the same, if all other calls of the file use their random numbers in the usual way
  value       // the result is another number: wrong, or the right value of another estimator
};

struct Explanation {
  Fault fault = Fault::none;
  std::string promise;        // of the contract, that the call breaks
  std::string got, expected;  // sentences about it
  pt::Rgb value{},
      off{};  // of a wrong value: what the record amounts to, and the result minus that
};

// `exact` traces the scene's primitives without the tasks. The promises are those of the task that was called.
Explanation explain_hemisphere(const pt::Scene& scene, const pt::Tracer& exact,
                               const pt::SurfacePoint& point, int samples, const Told& told);
Explanation explain_lights(const pt::Scene& scene, const pt::Tracer& exact,
                           const pt::SurfacePoint& point, int samples, const Told& told);
Explanation explain_path(const pt::Scene& scene, const pt::Tracer& exact,
                         const pt::SurfacePoint& start, const pt::PathSettings& settings,
                         const Told& told);

// The radiances are those that radiance() returned, in order.
Explanation explain_pixel(int samples, pt::Rgb mean, std::span<const pt::Rgb> radiances);
Explanation explain_adaptive(const pt::AdaptiveSettings& settings,
                             const pt::PixelEstimate& estimate, std::span<const pt::Rgb> radiances);

// A call that draws must move the sampler on.
Explanation explain_sampler(const char* promise, const State& before, const State& after);

// Returns whether two values agree, but for the precision that contracts allow, and `more`. NaN does not.
inline bool close(double a, double b, double tolerance = 1e-4) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)) || a == b;
}
inline bool close(pt::Rgb a, pt::Rgb b, double tolerance = 1e-4, double more = 0) {
  const double size = std::max(max_channel(a), max_channel(b)) * tolerance + more;
  return a == b || (std::abs(a.r - b.r) <= size && std::abs(a.g - b.g) <= size &&
                    std::abs(a.b - b.b) <= size);
}

// Four digits; a colour that is gray as one number.
std::string brief(double value);
std::string brief(pt::Rgb color);

}  // namespace grader::explain
