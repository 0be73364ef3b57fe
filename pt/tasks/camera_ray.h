#pragma once

#include "pt/geometry/ray.h"
#include "pt/scene/camera.h"

namespace pt {

// The ray from the camera through a point of its picture.
//
// In:  x and y in [0, 1], from the left edge to the right and from the bottom edge to the top:
//      (0, 0) is the bottom left corner, (1/2, 1/2) the centre.
// Out: the ray, in world space. Its origin is the camera's position, the direction has unit length,
//      and its range is near_clip .. far_clip.
//
// The picture is a window at distance 1 in front of the camera, at z = -1 of the camera's frame.
// The fields of view, in degrees, give its size. Seen from the camera, the angle between the left
// and the right edge is hfov_deg, and the angle between the bottom and the top edge is vfov_deg.
// The number of pixels does not matter.
//
// Promises:
//   - starts at the camera: the origin is the camera's position.
//   - has a unit direction: so that t is a distance.
//   - looks along minus z: the centre of the picture is straight ahead.
//   - fills the field of view: the angle from the centre to the middle of the left or right edge is
//     half of hfov_deg; to the middle of the bottom or top edge it is half of vfov_deg. The two
//     angles are independent.
//   - puts x to the right and y up: if x grows, the ray turns towards the frame's x axis; if y
//     grows, towards its y axis.
//   - keeps the picture flat: equal steps in x or y are equal steps on the flat window.
//   - turns with the camera: if the camera is moved or turned, its rays move and turn with it.
//   - keeps the clip range: t_min is near_clip and t_max is far_clip.
//
// Precision: for fields of view up to 170 degrees, the ray passes its point of the window at a
// distance of at most 1e-5 of the window's width and height. An error of 1e-6 in the unit direction
// is always accepted. So single precision and 3.14159 are enough. The length of the direction
// differs from 1 by at most 1e-5. The origin and the clip range are the camera's, in single or in
// double precision.
//
// May call: no other task.
// Threads: it is called from several threads at once, so nothing static may change.
Ray camera_ray(const Camera& camera, double x, double y);

}  // namespace pt
