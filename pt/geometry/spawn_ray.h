#pragma once

#include "pt/geometry/ray.h"
#include "pt/geometry/surface_point.h"

namespace pt {

// The error of a computed hit point is some tens of rounding errors (2^-53 each) of the numbers it
// was computed from. The offset has to exceed this error, but stay far below any detail of a scene.
// 2^-33 is 10^4 times the error (compare Waechter and Binder 2019, Ray Tracing Gems, chapter 6,
// which does the same in single precision).
inline constexpr double kOffset = 0x1p-33;

// The origin of a ray that leaves the surface along `direction`: p, moved off the true surface to
// the side the ray leaves on.
inline Vec3 offset_point(const SurfacePoint& point, Vec3 direction) {
  const double side = dot(point.geometric_normal, direction) < 0 ? -1 : 1;
  return point.p + (side * kOffset * point.scale) * point.geometric_normal;
}

// A ray from the surface along the unit `direction` (world space) that does not meet the surface it
// starts on.
inline Ray spawn_ray(const SurfacePoint& point, Vec3 direction) {
  return {offset_point(point, direction), direction, 0, kInfinity, point.triangle};
}

// A ray that tests whether anything stands between the point and a light at `distance` along the
// unit direction `wi`, both as sample_light gives them (the distance may be infinite). It ends a
// little before the light, which may be a surface of the scene itself. To a light at a finite
// distance its direction is the whole way there, so that t runs from 0 to almost 1.
inline Ray shadow_ray(const SurfacePoint& point, Vec3 wi, double distance) {
  // Single precision can distinguish the light from the ray's end at this distance.
  constexpr double kShorten = 1 - 0x1p-14;
  const Vec3 origin = offset_point(point, wi);
  if (!(distance < kInfinity)) return {origin, wi, 0, kInfinity, point.triangle};
  // Aimed at the light from where it starts: far from the world's origin the offset is larger than
  // what is cut off, and a ray along wi would end behind the light.
  return {origin, distance * wi - (origin - point.p), 0, kShorten, point.triangle};
}

}  // namespace pt
