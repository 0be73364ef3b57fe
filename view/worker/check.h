#pragma once

#include "view/worker/path.h"

#include <algorithm>
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

// Returns whether two values agree, but for the precision that contracts allow. NaN does not.
inline bool close(double a, double b, double tolerance = 1e-4) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)) || a == b;
}
inline bool close(pt::Rgb a, pt::Rgb b, double tolerance = 1e-4) {
  const double size = std::max(max_channel(a), max_channel(b)) * tolerance;
  return a == b || (std::abs(a.r - b.r) <= size && std::abs(a.g - b.g) <= size &&
                    std::abs(a.b - b.b) <= size);
}

// The tangent of half an angle.
inline double half_tangent(double degrees) { return std::tan(degrees * pt::kPi / 360); }

}  // namespace view
