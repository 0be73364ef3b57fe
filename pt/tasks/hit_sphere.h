#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"

#include <optional>

namespace pt {

// Finds where a ray first meets a sphere, from outside or from inside.
//
// In:  a sphere and a ray in world space. No coordinate of the centre is larger than a million
//      radii. The direction may have any length except zero. The point at t is
//      origin + t direction, so if the direction is twice as long, t is half as large.
// Out: nothing, or the smallest t with t_min <= t <= t_max at which the ray is on the sphere, and
//      the unit normal at this point, which points outwards.
//
// Promises:
//   - hits where it is aimed: a ray that is aimed at a visible point of the sphere hits at that
//     point, also where ray and surface are almost parallel.
//   - misses beside the sphere: a ray has no hit if it stays farther from the centre than the
//     radius.
//   - finds the near side: if the ray meets the sphere at two points in its range, the result is
//     the first.
//   - hits from inside: a ray that starts inside, or whose range begins inside, hits the far point.
//   - keeps t inside the ray: no hit before t_min, behind the origin, or beyond t_max.
//   - returns the outward unit normal: at the point that is hit, also seen from inside.
//   - works for directions of any length: if the direction is twice as long, t is half as large,
//     for lengths from 1e-9 to 1e9.
//   - stays accurate at a distance: if the ray starts up to a thousand radii away, the point lies
//     within 1e-6 radii of the surface.
//   - stays accurate at any distance (bonus): the same, up to ten million radii away (Haines,
//     Guenther, Akenine-Moeller 2019, Precision Improvements for Ray/Sphere Intersection, Ray
//     Tracing Gems, chapter 7).
//
// Precision: up to a thousand radii away, the point at t lies within 1e-6 radii of the surface, and
// n is right to 1e-6. The quadratic formula is precise enough for this in double precision, but not
// in single precision. If the point is within 1e-6 radii of an end of the range, hit and miss are
// both right. If a move of the ray by 1e-8 radii can turn a hit into a miss or a miss into a hit,
// both are right.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray);

}  // namespace pt
