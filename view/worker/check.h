#pragma once

#include "grader/explain/explain.h"
#include "view/worker/path.h"

#include <cmath>

namespace view {

// Holds the calls of a pixel's paths against their contracts, where one call tells, and adds what it finds. It is evidence
// from one path: a verdict comes from ./run grade.
// `exact` traces rays without the tasks.
void check_calls(const pt::View& view, const pt::Tracer& exact, PixelPaths& pixel,
                 const Settings& settings);

// Parts of it.
void check_camera(const pt::View& view, const Settings& settings, PixelPaths& pixel);
void check_hits(const pt::Scene& scene, const pt::Tracer& exact, Path& path);
void check_direct(const pt::Scene& scene, const pt::Tracer& exact, int bounce, const Bounce& at,
                  std::vector<Finding>& found);
void check_sample(int bounce, const Bounce& at, std::vector<Finding>& found);
void check_path(const pt::PathSettings& settings, Path& path);

using grader::explain::close;

// The tangent of half an angle.
inline double half_tangent(double degrees) { return std::tan(degrees * pt::kPi / 360); }

}  // namespace view
