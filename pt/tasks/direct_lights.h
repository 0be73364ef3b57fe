#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"

namespace pt {

// Direct light at a point, found by asking each light: far less noise than looking around.
//
// In:  a point of the scene; point.frame turns world directions into local directions;
//      samples >= 1.
// Out: an unbiased estimate of the radiance that leaves the point along wo after exactly one
//      bounce: the sum over all lights of the mean over `samples` draws of f L cos(wi) / pdf, where
//      sample_light gives wi, L and pdf, and L counts only if nothing stands between. A delta light
//      has one direction: one draw says everything, and more would only cost time.
//
// shadow_ray makes the rays. An area light with a surface of its own must not be hidden by it.
//
// Promises:
//   - matches a rectangle: Lambert's formula, wide and narrow, tilted and off to the side.
//   - matches a sphere: pi L (R / D)^2 irradiance on a surface that faces it.
//   - matches a point light: intensity / distance^2, at every angle.
//   - matches a directional light: irradiance times the cosine.
//   - matches the sky: half of it for an upright wall.
//   - adds the lights up: the sum of what each gives alone, however many, with any samples.
//   - averages over the samples: the mean does not depend on how many there are.
//   - takes the samples asked for: more of them lower the noise.
//   - is exact for delta lights: without any noise, whatever `samples` is.
//   - casts shadows: a surface between point and light hides it, or the part of it behind.
//   - is not hidden by the light itself: nor by what stands behind it.
//   - keeps light on its side: none from below the surface, also when seen from behind, and none
//     from the dark side of a light.
//   - reflects the albedo: channel by channel.
//   - turns with the surface: the same answer for every orientation of everything.
//   - starts off the surface: a surface never shadows itself, and what is close to it still
//     does, at every scale.
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler);

}  // namespace pt
