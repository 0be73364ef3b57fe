#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"

#include <optional>

namespace pt {

// Where a ray first meets a sphere, from outside or from inside.
//
// In:  world space. The direction may have any length but zero; t counts in that length.
// Out: nothing, or the smallest t with t_min <= t <= t_max on the sphere, and the unit normal
//      there, pointing outwards. A ray that only touches the sphere may hit or miss.
//
// Promises:
//   - hits where it is aimed: a ray at a visible point of the sphere has t at that point.
//   - misses beside the sphere: a ray that passes at more than the radius has no hit.
//   - finds the near side: of two points in the range the first is reported.
//   - hits from inside: a ray that starts inside has the far point.
//   - keeps t inside the ray: no hit before t_min, behind the origin, or beyond t_max.
//   - returns the outward unit normal: at the reported point, also seen from inside.
//   - counts t in the direction's length: a direction twice as long has half the t.
//   - stays accurate at a distance: at a thousand radii the point lies on the sphere to 1e-6 radii.
//   - stays accurate at any distance (bonus): at ten million radii still to 1e-6 (Haines et al.
//   2019,
//     Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, chapter 7).
std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray);

}  // namespace pt
