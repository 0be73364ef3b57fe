#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <optional>

namespace pt {

// Finds where a ray is inside a box.
//
// In:  world space. The box is not empty, but may be flat in one or more axes. The direction may
//      have any length but zero, and any of its components may be 0 or -0; t counts in that length.
// Out: nothing, or the part of the ray's own range [t_min, t_max] in which it is inside the box.
//
// Precision: both ends are right for a box whose planes are moved by at most 1e-12 of the largest
// coordinate there is (of the box and of the origin). Plain arithmetic in double keeps that. A few
// rounding errors too wide is right, too narrow is not: a box hides what is inside it.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
//
// Promises:
//   - hits where it is aimed: a ray at a point inside the box, or on a side that faces the ray,
//     has an interval, however flat it meets the side.
//   - misses beside the box: a ray that passes it has none.
//   - gives the right interval: where the ray enters and leaves, on every axis.
//   - starts inside: from an origin in the box or on one of its sides the interval starts at t_min.
//   - keeps to the ray's range: a box before t_min, behind the origin or beyond t_max is a miss,
//     and the interval lies in the range.
//   - takes rays along the axes: components of 0 and of -0, beside and inside the slabs.
//   - takes directions of any length: from a billionth to a billion.
//   - works at every scale: boxes from a billionth to a billion across, also far from the world's
//     origin, and up to a billion of their sizes away from the ray's.
//   - takes flat boxes: with no thickness in one axis or more.
//   - never misses by a rounding error (bonus): also for rays at the edges and corners of the boxes
//     of triangles, which have to be hit when the triangle is (Ize 2013, Robust BVH Ray Traversal,
//     JCGT 2(2)).
//   - takes rays in its sides (bonus): the origin in the plane of a side, the direction's component
//     there 0 or -0. The plane belongs to the box.
std::optional<Interval> hit_box(const Box& box, const Ray& ray);

}  // namespace pt
