#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <optional>

namespace pt {

// Finds where a ray is inside a box.
//
// In:  world space. The box is not empty, but may be flat in one or more axes. The direction may
//      have any length except zero, and components of 0 and -0. The point at t is
//      origin + t direction, so a direction twice as long halves t.
// Out: nothing, or the part of the ray's own range [t_min, t_max] in which it is inside the box.
//
// Promises:
//   - hits where it is aimed: a ray at a point inside the box, or on a side that faces the ray, has
//     an interval, however flat the angle to the side.
//   - misses beside the box: a ray that passes beside the box has no interval.
//   - gives the right interval: from where the ray enters to where it leaves, on every axis.
//   - begins at t_min inside the box: if the origin is in the box or on a side of it, the interval
//     starts at t_min.
//   - keeps to the ray's range: a box before t_min, behind the origin or beyond t_max is a miss,
//     and the interval lies in the range.
//   - takes rays along the axes: with components of 0 and of -0, inside and outside the slabs.
//   - works for directions of any length: from a billionth to a billion.
//   - works at every scale: boxes from a billionth to a billion across, also far from the world's
//     origin, and up to a billion times their size away from the ray's origin.
//   - takes flat boxes: with no thickness in one axis or more.
//   - never misses by a rounding error (bonus): if a ray hits a triangle, it hits the triangle's
//     box too, also at edges and corners of the box (Ize 2013, Robust BVH Ray Traversal, JCGT
//     2(2)).
//   - hits rays in the plane of a side (bonus): the origin is in this plane, and the direction's
//     component across it is 0 or -0. The plane belongs to the box.
//
// Precision: the error of an end may be as large as if its plane had moved by 1e-12 of the largest
// coordinate (of the box and of the origin). Plain arithmetic in double is enough. An interval that
// is too wide by a few rounding errors is right. An interval that is too narrow is wrong: it hides
// what is in the box.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
std::optional<Interval> hit_box(const Box& box, const Ray& ray);

}  // namespace pt
