#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/path_settings.h"
#include "pt/scene/scene.h"

namespace pt {

// The light that leaves a point after one bounce or more.
//
// In:  a point of the scene, seen along wo, with dot(n, wo) > 0. The settings are the bounces to
//      add up (from .. to, 0 <= to <= 100; none if from > to), the estimator of direct light, its
//      number of samples (1 .. 100), and the probability `survival` that a path goes on, in (0, 1].
// Out: an unbiased estimate of the radiance that leaves the point along wo: the sum over all bounces
//      k >= 1 with from <= k <= to. Emission (k = 0) is not among them: radiance() adds
//      it.
//
// Bounce 1 is direct light at the point itself: direct_hemisphere or direct_lights, as the settings
// say. Bounce k is direct light at the k-th point of the path, times the throughput. At each point
// before that, the path turned into a new direction wi. The throughput is the product of
// f cos / pdf of these turns. diffuse_sample chooses wi, with any density: use the f and pdf that
// it returns. The path goes on with spawn_ray and scene.closest. Its next point is on the first
// surface that the ray meets. If the ray meets nothing, the path ends: indirect rays see no sky. A
// path has at most `to` points.
//
// Russian roulette: the path always goes on from its first point to the second. From every later
// point it goes on with the probability `survival`, and all light that it finds after that is
// divided by `survival`. (Another probability is right too, fixed or computed from the throughput,
// if the noise stays within the limit below.)
//
// Promises:
//   - starts with direct light: with to = 1 it is only the direct light, by the method in settings.
//   - takes the light samples asked for: more light samples lower the noise of direct light.
//   - matches the furnace: in a closed room of emission E and albedo a it adds
//     E (a + a^2 + ... + a^to), for every `to`.
//   - adds up the bounces asked for: only bounces from .. to, and nothing if from > to.
//   - does not depend on survival: the mean is the same with survival .05 and with 1, and the noise
//     stays below the limit of the contract.
//   - takes the first bounce always: roulette starts at the second point of the path.
//   - stops after the last bounce: it never adds bounce `to` + 1, also if almost every path
//     survives.
//   - reaches the last bounce: in a closed room, only roulette ends a path before bounce `to`,
//     however large `to` is, and however small the throughput.
//   - counts emission once: the emission of a surface that the path meets is not added to direct
//     light.
//   - tints at each bounce: the f of a turn has the albedo of the point where the path turns, in
//     each channel.
//   - weighs by the cosine: the light that a point gets from a wall in the sun agrees with
//     Lambert's formula.
//   - divides by the pdf of the sample: the pdf that diffuse_sample returned, whatever density it
//     uses.
//   - follows the new ray: the next point is where the chosen direction leads.
//   - adds no light from outside: a path that leaves the scene ends, and sees no sky.
//   - keeps what it has found: if a path leaves the scene, the light that it found before counts.
//   - takes any amount of light: radiances of 1e-4 or 1e6, from one light or forty, at every scale.
//   - draws from the sampler alone: the same sampler state gives the same estimate, whatever was
//     called before; each call moves the sampler on, so that the next estimate is new.
//   - stays finite: also with albedo 0, or if the point is seen almost along the surface.
//
// Noise: to find the limit, take the method above with more noise than it needs: with the survival
//      .3 if `survival` is larger, and with a diffuse_sample and a direct light that are as noisy
//      as their contracts allow. The standard deviation of one estimate may be twice that of this
//      method. For example, in a ball of albedo 1/2 with a point light in its centre, let the
//      direct light be 1 at each point. The sum of bounces 1 .. 5 is 1.94. The method above, with
//      survival .7 and cosine-weighted directions, has a standard deviation of 0.33, and the limit
//      is 5.5. With more noise than the limit, the verdict is "too noisy".
//
// Precision: the radiance of each bounce is right to 1e-5 of its size. Single precision is enough
// for colours.
//
// May call: the tasks diffuse_bsdf, direct_hemisphere and direct_lights; scene.closest,
//      scene.occluded, surface_point, background and sample_light; and functions that a header of
//      pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler);

}  // namespace pt
