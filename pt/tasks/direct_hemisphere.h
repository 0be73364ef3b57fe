#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"

namespace pt {

// Direct light at a point, by hemisphere sampling: rays in all directions over the surface, most of
// which meet no light.
//
// In:  a point of the scene; point.frame turns local directions into world directions;
//      samples >= 1. Radiances are of any size (1e-4 to 1e6), and so are scenes (1e-6 to 1e6),
//      which may lie up to ten thousand times their size away from the world's origin.
// Out: an unbiased estimate of the radiance that leaves the point along wo after exactly one
//      bounce: the mean over `samples` uniform directions wi of f L cos(wi) / pdf, where L is the
//      emission of the surface that a ray along wi meets (towards the point), or background() where
//      it meets none.
//
// spawn_ray makes the rays; surface_point gives the emission of what they hit. Delta lights are
// never met. The sampler is the only source of random numbers.
//
// Precision: apart from noise, to 1e-5 of its size. Single precision keeps that for colors and
// cosines, not for points.
//
// Noise: the standard deviation of the estimate is at most that of the mean of `samples`
// independent uniform directions.
//
// May call: the task diffuse_bsdf; scene.closest, scene.occluded, surface_point, background and
//      sample_light; and functions that a header of pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
//
// Promises:
//   - sees the sky: where rays meet nothing; half of it from an upright wall.
//   - sees a light of known size: Lambert's formula for a rectangle, wherever it is.
//   - sees lights of any brightness: from very dim to very bright, unclamped.
//   - takes the emission of what is hit: not the shaded point's own, nor that of a light in the
//     list that has no surface.
//   - adds no emission of its own: a glowing surface reflects only what arrives.
//   - sees what is in the way: a dark surface hides what is behind it, also just before a
//     light; one just behind the light hides nothing.
//   - sees only the bright side: a light is dark from behind.
//   - turns with the surface: the same answer for every orientation of everything.
//   - looks from the side it is seen on: also where that is the back of the surface.
//   - reflects the albedo: channel by channel.
//   - takes the samples asked for: the mean is the same for any number of them, and the noise falls
//     with its square root, up to a thousand and more.
//   - starts off the surface: a surface never meets itself, and no ray passes through what lies
//     close to it, at every scale.
//   - spreads evenly over the hemisphere: directions are uniform above the surface, down to the
//     horizon.
//   - goes on with the sampler: calls one after the other are independent; a sampler in the same
//     state gives the same estimate again.
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler);

}  // namespace pt
