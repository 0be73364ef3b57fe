#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/scenes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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

// The same, but the normal of the true surface is up to 1.3 radians away from n, as at the corner of
// a coarse mesh, and the point is seen from between the two. Many directions above n lead below the
// true surface. The point is on a dark square of the given side, which hides nothing from it.
inline Situation strongly_interpolated(SceneMaker maker, pt::Rgb albedo, double side) {
  const double tilt = *real(0.8, 1.3), azimuth = *real(-pt::kPi, pt::kPi), r = std::sin(tilt);
  const pt::Vec3 n{r * std::cos(azimuth), r * std::sin(azimuth), std::cos(tilt)};
  const pt::Frame true_frame = pt::frame_from_normal(n);
  maker.surface({{}, side * true_frame.x, side * true_frame.y}, albedo);
  Situation s = maker.point(albedo, normalize(n + pt::Vec3{0, 0, 1})).done();
  const pt::Triangle& own = s.scene.primitives.triangles.back();
  s.point.geometric_normal = normalize(cross(own.p1 - own.p0, own.p2 - own.p0));
  s.text += fmt::format("the point is on a small surface whose true normal is {}\n", brief(n));
  return s;
}

// Returns a shading normal for the rectangle, up to 1.2 radians away from its true normal. All points
// of the rectangle are seen from the origin on the same side of it.
inline pt::Vec3 smooth_normal(const Rectangle& shape) {
  const double azimuth = *real(-pt::kPi, pt::kPi);
  const pt::Frame facing = pt::frame_from_normal(shape.n());
  const pt::Vec3 aside = facing.to_world({std::cos(azimuth), std::sin(azimuth), 0});
  double most = 1.2;
  for (const pt::Vec3 corner : shape.corners()) {
    if (dot(corner, aside) > 0) {
      most = std::min(most, 0.9 * std::atan(-dot(corner, facing.z) / dot(corner, aside)));
    }
  }
  const double tilt = most * *real(0.7, 1);
  return std::cos(tilt) * facing.z + std::sin(tilt) * aside;
}

}  // namespace grader::check
