#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"

namespace pt {

// Direct light at a point, by light sampling: far less noise than hemisphere sampling.
//
// In:  a point of the scene; point.frame turns world directions into local directions;
//      samples >= 1. There may be any number of lights (none, or 40), with radiances from 1e-4 to
//      1e6. Sizes of scenes are from 1e-6 to 1e6. A scene may lie up to ten thousand times its size
//      away from the world's origin.
// Out: an unbiased estimate of the radiance that leaves the point along wo after exactly one
//      bounce: the sum over all lights of the mean over `samples` draws of f L cos / pdf.
//      sample_light gives wi, L and pdf; cos is the cosine of the angle between wi and the normal.
//      (Without f, the result is the irradiance of the point.) A draw counts only if no surface is
//      between the point and the light. A delta light (a point light or a directional light) has
//      only one direction: one draw is exact, and more would only cost time.
//
// shadow_ray makes the rays. An area light with a surface of its own must not be hidden by it. The
// sampler is the only source of random numbers.
//
// Promises:
//   - matches a rectangle: the mean agrees with Lambert's formula for rectangles that are wide or
//     narrow, tilted, or off to the side.
//   - matches a sphere: at the distance D from the centre of a sphere of radius R, a surface that
//     faces the sphere has the irradiance pi L (R / D)^2.
//   - matches a point light: the irradiance is intensity / distance^2 times the cosine, also for
//     light that comes almost along the surface.
//   - matches a directional light: the irradiance is the light's irradiance times the cosine, also
//     for light that comes almost along the surface.
//   - matches the sky: a horizontal surface gets all of its light, an upright wall half of it.
//   - adds the lights up: the result is the sum of the results for each light alone, for any number
//     of lights and samples.
//   - takes lights of any brightness: from very dim to very bright, without clamping.
//   - averages over the samples: the mean does not depend on their number.
//   - takes the samples asked for: the noise falls with the square root of their number, up to a
//     thousand samples and more.
//   - is exact for delta lights: without any noise, whatever `samples` is.
//   - casts shadows: a surface between the point and a light hides the light, or a part of it. The
//     surface can be anywhere from close to the point up to 0.999 of the distance to the light.
//   - is not hidden by the light itself: nor by anything behind the light.
//   - keeps light on its side: no light comes from below the surface, also if the surface is seen
//     from behind, and none from the dark side of a light.
//   - reflects the albedo: each channel of the light is multiplied by that channel of the albedo.
//     The emission of the point itself is not counted.
//   - works in every orientation: the answer is the same if the whole scene is rotated.
//   - starts off the surface: a surface never shadows itself, but another surface close to it still
//     does. This holds at every scale, and also on a smooth mesh, where n is not the normal of the
//     true surface.
//   - draws from the sampler alone: consecutive calls are independent, and a sampler in the same
//     state gives the same estimate again.
//
// Noise: the standard deviation of one draw of a light is at most the larger of two numbers: twice
// the standard deviation of a draw by sample_light, and the mean of the draws of this light. The
// mean of `samples` draws has at most this limit divided by the square root of `samples`. Draws of
// different lights are independent. A method that draws only one of the lights, chosen at random
// or by resampling, can be right on average, but it is not allowed: the part of a dim light among
// bright ones has more noise than this.
//
// Precision: apart from noise, the part of each light is right to 1e-5 of its size, and the cosine
// in it to 1e-6. Single precision is enough for colours and cosines, but not for points and
// distances.
//
// May call: the task diffuse_bsdf; scene.closest, scene.occluded, surface_point, background and
//      sample_light; and functions that a header of pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler);

}  // namespace pt
