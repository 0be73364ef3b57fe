#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"
#include "pt/scene/view.h"

namespace pt {

// The light that leaves a point after one bounce or more.
//
// In:  a point of the scene, seen along wo. Of settings: which bounces to add up (from .. to), how
//      direct light is estimated and with how many samples, and the chance `survival` to go on.
// Out: an unbiased estimate of the radiance that leaves the point along wo after k bounces, summed
//      over all k >= 1 with from <= k <= to. Emission (k = 0) is not among them: radiance() adds
//      it.
//
// Bounce 1 is direct light at the point itself: direct_hemisphere or direct_lights, as settings
// say. Bounce k is direct light at the k-th point of the path, weighted by f cos / pdf of each turn
// on the way. The path turns by diffuse_sample and moves on by spawn_ray and scene.closest; what it
// meets first is the next point; where it meets nothing, it ends (indirect rays see no sky).
//
// The first turn is certain. Before every later one, the path survives with the chance `survival`,
// and what it finds from there on is divided by it. It never bounces more than `to` times.
//
// Promises:
//   - starts with direct light: with to = 1 it is the direct light alone, by the way chosen.
//   - takes the light samples asked for: more of them lower the noise of direct light.
//   - matches the furnace: in a closed room of emission E and albedo a it adds
//     E (a + a^2 + ... + a^to), for every `to`.
//   - adds up the bounces asked for: from .. to and no other.
//   - does not depend on survival: neither .3 nor 1 changes the mean.
//   - takes the first turn always: roulette starts with the second.
//   - ends at the cap: never more than `to` bounces, also where almost every path survives.
//   - counts emission once: what the path runs into is not added to what direct light gave.
//   - tints at each bounce: by the albedo of the point it leaves, channel by channel.
//   - weighs by the cosine: a wall in the sun brings what Lambert's formula says.
//   - follows the new ray: the next point is where the chosen direction leads.
//   - brings nothing from outside: a path that leaves the scene sees no sky.
//   - stays finite: also with albedo 0, and seen exactly along the surface.
Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler);

}  // namespace pt
