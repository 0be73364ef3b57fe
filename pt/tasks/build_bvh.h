#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/bvh.h"
#include "pt/geometry/bvh_builder.h"

#include <span>

namespace pt {

// A bounding volume hierarchy over boxes, with the invariants of pt/geometry/bvh.h.
//
// In:  any number of boxes of primitives, in world space; the number may be zero. No box is empty,
//      but boxes may be flat or single points. max_leaf >= 1.
// Out: the tree. No leaf holds more than max_leaf primitives, whatever the boxes are. A BvhBuilder
//      (pt/geometry/bvh_builder.h) makes the tree from its leaves up, and keeps the invariants.
//
// Any rule may split the boxes: the midpoint of the longest axis of the box of all centroids (the
// centres of the boxes), the mean, the median, the surface area heuristic. If no plane separates
// some boxes, the function must divide them in another way.
//
// Promises:
//   - keeps every primitive once: `order` holds each index once, and each place of `order` belongs
//     to exactly one leaf.
//   - covers its primitives: a node's box contains all boxes below it, and is larger by at most a
//     few rounding errors.
//   - is one tree: every node but the root has one parent, whose index is smaller.
//   - keeps leaves small: at most max_leaf primitives each, for every max_leaf >= 1, also in the
//     deepest parts of a deep tree.
//   - splits until it must: n boxes with n > max_leaf are not left in one leaf, and both children
//     of an inner node hold primitives.
//   - takes no boxes and one: zero boxes make an empty tree, and one box makes a single leaf.
//   - ends on identical centroids: the function returns, also if all boxes are equal, or some of
//     them.
//   - ends where axes are equally long: the function returns, also for boxes on a cubic grid, or
//     along a diagonal.
//   - separates along the longest axis: for a long row of boxes along x, y or z, or several
//     parallel rows, at any scale, a ray across the row enters few boxes of the tree: 64 at most,
//     on average, of 2,048 and of 32,768.
//   - stays shallow on clustered centroids (bonus): with centroids at 2^-i or -2^-i for i =
//     0, 1, ... the depth grows like the logarithm of the number of boxes.
//
// Precision: a node's box contains the boxes below it exactly, as with Box::grow: its sides are
// numbers of these boxes, copied in double precision without any rounding. It may be larger by a
// few rounding errors of double precision. If it is even larger, it is wrong: rays would enter it
// without need.
//
// May call: leaf, inner and finish of a BvhBuilder. No other task.
// Threads: it is called from several threads at once, so nothing static may change.
Bvh build_bvh(std::span<const Box> boxes, int max_leaf);

}  // namespace pt
