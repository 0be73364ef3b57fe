#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/bvh.h"

#include <span>

namespace pt {

// A bounding volume hierarchy over boxes, with the invariants of pt/geometry/bvh.h.
//
// In:  the boxes of the primitives, in world space, none empty (flat ones and points are possible),
//      in any number, zero included. max_leaf >= 1.
// Out: the tree. No leaf holds more than max_leaf primitives, whatever the boxes are.
//
// Any rule may split the boxes: the midpoint of the longest axis of the box of all centroids, the
// mean, the median, the surface area heuristic. Boxes that a plane fails to separate must be
// divided in another way.
//
// Precision: a node's box contains the boxes below it exactly, as Box::grow makes it: it is made of
// their own numbers in double, and none of them is rounded. It may be larger by a few rounding
// errors of double, not more: a ray enters every box that is too large.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
//
// Promises:
//   - keeps every primitive once: order is a permutation, and the leaves cover it without overlap.
//   - covers its primitives: a node's box contains all boxes below it, and hardly more.
//   - is one tree: every node but the root has one parent, whose index is smaller.
//   - keeps leaves small: at most max_leaf primitives each, for max_leaf from 1 up, also in the
//     deepest parts of a deep tree.
//   - splits until it must: n boxes with n > max_leaf are not left in one leaf, and inner nodes
//     have two children that both hold something.
//   - takes no boxes and one: an empty tree, and a single leaf.
//   - ends on identical centroids: also when every box is the same, and when some of them are.
//   - ends where axes are equally long: boxes in a cube of rows, or along a diagonal.
//   - separates along the longest axis: long rows of boxes along x, y or z, at any scale, and rows
//     of such rows, give a tree in which a ray across the row enters few boxes.
//   - stays shallow on clustered centroids (bonus): at 2^-i for i = 0, 1, ... the depth is
//     logarithmic.
Bvh build_bvh(std::span<const Box> boxes, int max_leaf);

}  // namespace pt
