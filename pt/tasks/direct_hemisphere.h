#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"

namespace pt {

// Direct light at a point, by hemisphere sampling: rays go in all directions above the surface, and
// most of them meet no light.
//
// In:  a point of the scene; point.frame turns local directions into world directions;
//      samples >= 1. Radiances are from 1e-4 to 1e6, sizes of scenes from 1e-6 to 1e6. A scene may
//      lie up to ten thousand times its size away from the world's origin.
// Out: an unbiased estimate of the radiance that leaves the point along wo after exactly one
//      bounce: the mean over `samples` uniform directions wi of f L cos / pdf. Here cos is the cosine
//      of the angle between wi and the normal. L is the emission, towards the point, of the surface
//      that a ray along wi meets, or background() if it meets none.
//
// spawn_ray makes the rays; surface_point gives the emission of the surfaces that they hit. No ray
// meets a delta light (a point light or a directional light). The sampler is the only source of
// random numbers.
//
// Promises:
//   - sees the sky: a ray that meets nothing counts the light of the sky; an upright wall sees half
//     of the sky.
//   - sees a light of known size: the mean agrees with Lambert's formula for a rectangle, wherever
//     it is.
//   - sees lights of any brightness: from very dim to very bright, without clamping.
//   - takes the emission of what is hit: not the emission of the point itself, and not that of a
//     light that has no surface.
//   - adds no emission of its own: the emission of the point itself is not counted.
//   - sees what is in the way: a dark surface hides what is behind it, also if that is a light just
//     behind it; a dark surface just behind a light hides nothing.
//   - sees only the bright side: a light is dark from behind.
//   - works in every orientation: the answer is the same if the whole scene is rotated.
//   - looks from the side it is seen on: rays leave on the side of wo, also if this is the back of
//     the surface.
//   - reflects the albedo: each channel of the light is multiplied by that channel of the albedo.
//   - takes the samples asked for: the mean does not depend on their number, and the noise falls
//     with the square root of their number, up to a thousand samples and more.
//   - starts off the surface: no ray meets the surface that it leaves, and none passes through
//     another surface close to it. This holds at every scale, and also on a smooth mesh, where n is
//     not the normal of the true surface.
//   - spreads evenly over the hemisphere: directions are uniform above the surface, down to the
//     horizon.
//   - draws from the sampler alone: consecutive calls are independent, and a sampler in the same
//     state gives the same estimate again.
//
// Noise: the standard deviation of the estimate is at most that of the same mean over `samples`
// independent uniform directions.
//
// Precision: apart from noise, the estimate is right to 1e-5 of its size. Single precision is
// enough for colours and cosines, but not for points.
//
// May call: the task diffuse_bsdf; scene.closest, scene.occluded, surface_point, background and
//      sample_light; and functions that a header of pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler);

}  // namespace pt
