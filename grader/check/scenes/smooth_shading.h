#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/scenes.h"

#include <cmath>

namespace grader::check {

// The same point, as on a mesh that is shaded smoothly: the normal of the true surface is 0.3 to
// 0.4 radians away from n. The point is seen from at most 1 radian from n, so that the viewer is
// above both.
inline pt::SurfacePoint smoothly_shaded(pt::SurfacePoint point) {
  const double tilt = *real(0.3, 0.4), azimuth = *real(-pt::kPi, pt::kPi);
  const double r = std::sin(tilt);
  const pt::Vec3 n{r * std::cos(azimuth), r * std::sin(azimuth), std::cos(tilt)};
  point.geometric_normal = point.frame.to_world(n);
  point.wo = point.frame.to_world(*direction_above(1.0));
  return point;
}

// The same scene with such a point. The answer has to be right for it: all lights are above both normals'
// horizons.
inline Situation smoothly_shaded(Situation s) {
  s.point = smoothly_shaded(s.point);
  s.text += "the normal of the true surface is not the shading normal\n";
  return s;
}

}  // namespace grader::check
