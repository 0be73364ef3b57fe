#pragma once

#include "pt/geometry/bvh.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/ray.h"

#include <optional>

namespace pt {

// Finds what a ray meets among many primitives, with the help of a tree over their boxes.
//
// In:  any tree that keeps the invariants of pt/geometry/bvh.h over the boxes of `primitives`, also
//      an empty one, one of a thousand levels, or one of three hundred thousand nodes.
// Out: hit_bvh returns the hit with the smallest t in the ray's range, with its normal unchanged,
//      and the primitive that was hit. If several have the same t, any of them is right.
//      occluded_bvh returns whether there is any hit in the ray's range; it stops at the first hit
//      that it finds.
//
// Promises:
//   - finds the nearest hit: t is the same as if every primitive had been tested. Among thousands
//     of primitives it tests fewer than half of them, and fewer than half of the boxes.
//   - says which primitive: index and normal belong to the primitive that was hit.
//   - misses what is not there: no hit if there is none when every primitive is tested.
//   - keeps t inside the ray: no hit before t_min or beyond t_max.
//   - takes an empty tree: without nodes there is no hit.
//   - takes a tree of any shape: one side much deeper than the other, a thousand levels deep, with
//     many primitives in a leaf, or a single leaf.
//   - finds any hit: occluded_bvh returns true exactly if there is a hit in the range.
//   - calls hit_box and hit_primitive: only their answers decide what the ray meets.
//   - tests few primitives: only primitives in leaves that the ray enters.
//   - tests no box twice: it tests each box and each primitive at most once in a call.
//   - skips what lies outside the ray: if the ray does not enter a box, nothing below it is
//     tested.
//   - skips what lies behind a hit: if many walls stand behind each other, it tests fewer than half
//     of them, on average over the two orders of the children.
//   - stops at any hit: occluded_bvh does not go on after it has found a hit.
//
// Precision: t and n are those that hit_primitive returned, unchanged.
//
// May call: hit_box for boxes, and hit_primitive for primitives, which calls the task hit_triangle
//      or hit_sphere. No other task.
// Threads: it is called from several threads at once, so nothing static may change.
std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray);
bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray);

}  // namespace pt
