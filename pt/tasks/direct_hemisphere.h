#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"

namespace pt {

// Direct light at a point, found by looking around: rays in all directions over the surface, most
// of which meet no light.
//
// In:  a point of the scene; point.frame turns local directions into world directions;
//      samples >= 1.
// Out: an unbiased estimate of the radiance that leaves the point along wo after exactly one
//      bounce: the mean over `samples` uniform directions wi of f L cos(wi) / pdf, where L is the
//      emission of the surface that a ray along wi meets (towards the point), or background() where
//      it meets none.
//
// spawn_ray makes the rays; surface_point gives the emission of what they hit. Delta lights are
// never met.
//
// Promises:
//   - sees the sky: where rays meet nothing; half of it from an upright wall.
//   - sees a light of known size: Lambert's formula for a rectangle, wherever it is.
//   - takes the emission of what is hit: not the shaded point's own, nor is a list of lights
//     asked.
//   - adds no emission of its own: a glowing surface in the dark reflects nothing.
//   - sees what is in the way: a dark surface hides the light behind it.
//   - sees only the bright side: a light turned away is dark.
//   - turns with the surface: the same answer for every orientation of everything.
//   - looks from the side it is seen on: also where that is the back of the surface.
//   - reflects the albedo: channel by channel.
//   - takes the samples asked for: the mean is the same for any number of them, and the noise falls
//     with its square root.
//   - starts off the surface: a surface never meets itself, nor is anything close to it passed
//     through, at every scale.
//   - spreads evenly over the hemisphere: directions are uniform above the surface.
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler);

}  // namespace pt
