#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/triangle.h"

#include <optional>

namespace pt {

// Finds where a ray meets a triangle.
//
// In:  a triangle and a ray in world space. The direction may have any length except zero. The
//      point at t is origin + t direction, so if the direction is twice as long, t is half as
//      large. The corner normals are unit vectors. Where the weighted sum of the corner normals is
//      zero, any n is right.
// Out: nothing, or t with t_min <= t <= t_max and the unit normal at this point: the corner normals
//      weighted by the barycentric coordinates of the point, normalised, and never turned to the
//      other side. A ray can hit the triangle from both sides.
//
// A ray in the triangle's plane misses, and so does every ray if the triangle has no area. Exactly
// on an edge, hit and miss are both right.
//
// Promises:
//   - hits where it is aimed: a ray that is aimed at a point inside the triangle hits at that
//     point, also in long and thin triangles, and if ray and plane are almost parallel.
//   - misses outside: a ray that meets the plane outside the triangle has no hit.
//   - keeps t inside the ray: no hit before t_min, behind the origin, or beyond t_max.
//   - interpolates the corner normals: each is weighted by the coordinate of its own corner.
//   - returns a unit normal: also if the corner normals differ.
//   - never flips the normal: it does not depend on where the ray comes from.
//   - hits both faces: whatever the order of the corners.
//   - works for directions of any length: if the direction is twice as long, t is half as large,
//     for lengths from 1e-9 to 1e9.
//   - works at every scale: triangles from a millionth to a million across.
//   - keeps double precision: t is right to 1e-9 of its size in well-shaped triangles.
//   - rejects what has no area: a triangle without area never gives a hit or NaN, and neither does
//     a ray in the triangle's plane.
//   - leaves no gap at shared edges (bonus): a ray that is aimed at an edge or a corner that
//     triangles share hits at least one of them (Woop, Benthin, Wald 2013, Watertight Ray/Triangle
//     Intersection, JCGT 2(1)).
//
// Precision: t is right to 1e-9 of the largest length (a coordinate, an edge, or the distance to
// the point), so single precision is not enough. n is right to 1e-6. For two kinds of input the
// allowed error is larger. In a long and thin triangle, it is multiplied by length / height of the
// triangle. If the ray is almost parallel to the plane, it is divided by the angle between ray and
// plane, in radians. Below an angle of 1e-6, the ray may miss, or hit with any t. If the point is
// closer than the allowed error to an edge or to an end of the range, hit and miss are both right.
// Three corners on one line have no area, but rounding can give them some: then a ray that meets
// this line may hit.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray);

}  // namespace pt
