#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/path_settings.h"
#include "pt/scene/scene.h"

namespace pt {

// The light that leaves a point after one bounce or more.
//
// In:  a point of the scene, seen along wo, with dot(n, wo) > 0. Of settings: which bounces to add
//      up (from .. to, 0 <= to <= 100; none if from > to), how direct light is estimated and with
//      how many samples (1 .. 100), and the chance `survival` to go on, in (0, 1].
// Out: an unbiased estimate of the radiance that leaves the point along wo after k bounces, summed
//      over all k >= 1 with from <= k <= to. Emission (k = 0) is not among them: radiance() adds
//      it.
//
// Bounce 1 is direct light at the point itself: direct_hemisphere or direct_lights, as settings
// say. Bounce k is direct light at the k-th point of the path, times the throughput: the product of
// f cos / pdf of each bounce on the way. diffuse_sample chooses the direction, by any density: its
// own f and pdf belong to it. The path moves on by spawn_ray and scene.closest; the first surface
// that it meets has the next point; where it meets nothing, it ends (indirect rays see no sky).
//
// The path always goes on from its first point to the second. From every later point it goes on
// with the chance `survival`, and what it finds from there on is divided by it. (Another chance,
// fixed or by the throughput, is right too if it is within the noise below.) It has at most `to`
// points.
//
// Precision: 1e-5 of the radiance of each bounce; float is enough for colors.
// Noise: one estimate has at most twice the standard deviation that the method above has with
//      survival .3 (or `survival`, if that is less) and with the most noise that the contracts of
//      diffuse_sample and of direct light allow. If it has more, the promise that was tried is
//      broken, as "too noisy".
// May call: the tasks diffuse_bsdf, direct_hemisphere and direct_lights; scene.closest,
//      scene.occluded, surface_point, background and sample_light; and functions that a header of
//      pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
//
// Promises:
//   - starts with direct light: with to = 1 it is the direct light alone, by the way chosen.
//   - takes the light samples asked for: more of them lower the noise of direct light.
//   - matches the furnace: in a closed room of emission E and albedo a it adds
//     E (a + a^2 + ... + a^to), for every `to`.
//   - adds up the bounces asked for: from .. to and no other; nothing if from > to.
//   - does not depend on survival: neither .05 nor 1 changes the mean.
//   - takes the first bounce always: roulette starts at the second point of the path.
//   - ends at the cap: never more than `to` bounces, also where almost every path survives.
//   - goes on up to the cap: nothing but roulette ends a path of a closed room before bounce `to`,
//     however many bounces that is, and however small its throughput.
//   - counts emission once: the emission of a surface that the path meets is not added to direct
//     light.
//   - tints at each bounce: by the albedo of the point it leaves, channel by channel.
//   - weighs by the cosine: a wall in the sun brings what Lambert's formula says.
//   - uses the density of the sample: the pdf that came with the direction, however it was chosen.
//   - follows the new ray: the next point is where the chosen direction leads.
//   - brings nothing from outside: a path that leaves the scene sees no sky.
//   - keeps what it has found: where a path leaves the scene, the light before that stays.
//   - takes any amount of light: 1e-4 or 1e6, from one light or forty, at every scale.
//   - draws from the sampler alone: the same sampler gives the same estimate, whatever was asked
//     earlier; afterwards it has moved on, and gives a new one.
//   - stays finite: also with albedo 0, and seen almost along the surface.
Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler);

}  // namespace pt
