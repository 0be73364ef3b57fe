#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/triangle.h"

#include <optional>

namespace pt {

// Finds where a ray meets a triangle.
//
// In:  world space. The direction may have any length but zero; t counts in that length. The corner
//      normals are unit vectors.
// Out: nothing, or t with t_min <= t <= t_max and the unit normal there: the corner normals
//      weighted by the barycentric coordinates of the point, normalised, on the side they are on.
//      Both faces are hit.
//
// A ray that runs in the triangle's plane, and any ray at a triangle without area, misses. On the
// very edge, hit or miss are both right.
//
// Precision: t is right to 1e-9 of the largest length involved (a coordinate, an edge, the way to
// the point), so single precision is not enough; n is right to 1e-6. In a sliver a thousand times
// as long as high the error may be a thousand times larger, and so on; likewise where the ray meets
// the plane at a small angle, down to a millionth of a radian. Flatter rays may miss, or hit with any
// t. If the point is closer than this error to an edge or to an end of the range, hit and miss are
// both right. If rounding gives an area to a triangle whose corners lie on one line, a ray that meets
// the line may hit.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
//
// Promises:
//   - hits where it is aimed: a ray at a point inside the triangle has t at that point, also in
//     slivers and where ray and plane are almost parallel.
//   - misses outside: a ray at a point of the plane outside all or any of the edges has no hit.
//   - keeps t inside the ray: no hit before t_min, behind the origin, or beyond t_max.
//   - interpolates the corner normals: each weighted by the coordinate of its own corner.
//   - returns a unit normal: also where the corner normals differ.
//   - never flips the normal: it does not depend on where the ray comes from.
//   - hits both faces: whichever way the corners run.
//   - counts t in the direction's length: a direction twice as long has half the t, for lengths
//     from 1e-9 to 1e9.
//   - works at every scale: triangles from a millionth to a million across.
//   - keeps double precision: t is right to 1e-9 of its size in well-shaped triangles.
//   - rejects what has no area: degenerate triangles and rays in the plane never hit, nor give NaN.
//   - leaves no gap at shared edges (bonus): a ray at an edge or a corner that triangles share
//     hits at least one of them (Woop, Benthin, Wald 2013, Watertight Ray/Triangle Intersection,
//     JCGT 2(1)).
std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray);

}  // namespace pt
