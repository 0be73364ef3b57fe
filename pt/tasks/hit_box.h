#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <optional>

namespace pt {

// Finds where a ray is inside a box.
//
// In:  a box and a ray in world space. The box is not empty, but may be flat in one or more axes.
//      The direction may have any length except zero, and components may be 0 or -0. The point at t
//      is origin + t direction, so if the direction is twice as long, t is half as large.
// Out: nothing, or the part of the ray's own range [t_min, t_max] in which the ray is inside the
//      box.
//
// Promises:
//   - hits where it is aimed: a ray that is aimed at a point inside the box, or on a side that
//     faces the ray, has an interval, however small the angle between the ray and the side.
//   - misses beside the box: a ray that passes beside the box has no interval.
//   - gives the right interval: from the t at which the ray enters to the t at which it leaves, on
//     every axis.
//   - begins at t_min inside the box: if the origin is in the box or on a side of it, the interval
//     starts at t_min.
//   - keeps to the ray's range: a box before t_min, behind the origin or beyond t_max is a miss,
//     and the interval lies in the range.
//   - takes rays along the axes: one or two components of the direction are 0 or -0, and the origin
//     is inside or outside the slabs of these axes.
//   - works for directions of any length: for lengths from a billionth to a billion.
//   - works at every scale: boxes from a billionth to a billion across, also far from the world's
//     origin, and up to a billion times their size away from the ray's origin.
//   - takes flat boxes: with no thickness in one axis or more.
//   - never misses by a rounding error (bonus): if a ray hits a triangle, it hits the triangle's
//     box too, also at edges and corners of the box (Ize 2013, Robust BVH Ray Traversal, JCGT
//     2(2)).
//   - hits rays in the plane of a side (bonus): a ray is in such a plane if its origin is, and if
//     the direction's component across the plane is 0 or -0. The sides belong to the box, so a ray
//     that meets the box only in a side has an interval.
//
// Precision: the t where the ray crosses a plane of the box may be the t of a shifted plane. The
// shift is at most 1e-12 of the largest coordinate (of the box and of the origin). Plain arithmetic
// in double precision is enough. An interval that is too wide by a few rounding errors is right. An
// interval that is too narrow is wrong: it hides what is in the box.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
std::optional<Interval> hit_box(const Box& box, const Ray& ray);

}  // namespace pt
