#pragma once

#include "pt/geometry/ray.h"
#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/view.h"

namespace pt {

// One sample of the radiance that comes back along a camera ray: estimate_pixel and adaptive_pixel
// average it. It is not a task, but is linked like one, with the implementations
//   path      emission at the first surface + trace_path, or the normals view; unchanged, even NaN
//             (pt/render/radiance_path.cpp);
//   recorded  the same, with each sample also added to this thread's PixelRecord; a sample that is
//             not finite becomes black (pt/render/radiance_recorded.cpp: the render program);
//   apart     the same, with each sample also split by bounces (pt/render/radiance_apart.h: the
//             write-up);
//   scripted  whatever a test wants the pixel to see (grader).
//
// In:  a world-space ray of unit direction. Black where it meets nothing.
Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler);

}  // namespace pt
