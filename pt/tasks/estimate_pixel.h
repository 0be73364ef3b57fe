#pragma once

#include "pt/math/rgb.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/view.h"

namespace pt {

// The mean radiance that falls on one pixel.
//
// In:  the pixel (x, y) counts from the bottom left corner of the picture: x in 0 .. width - 1,
//      y in 0 .. height - 1. It covers the square from (x / width, y / height) to
//      ((x + 1) / width, (y + 1) / height) of camera_ray's picture. samples >= 1.
// Out: the mean of radiance(scene, ray, settings, sampler) over `samples` camera rays. A single
//      sample goes through the pixel's centre. If there are more, each goes through a random point of
//      the pixel, and all points are equally likely.
//
// Promises:
//   - averages the radiance: the result is the mean of the values of radiance(), channel by
//     channel, whether they are 0 or a million.
//   - takes the samples asked for: radiance() is called exactly `samples` times, once or thousands
//     of times.
//   - sends one sample through the centre: if samples = 1.
//   - stays inside the pixel: every ray goes through the pixel's own square.
//   - covers the whole pixel: with more than one sample, all points of the square are equally
//     likely.
//   - passes the settings on: radiance() gets the view's scene and settings.
//   - draws from the caller's sampler: never from a copy, and never from a sampler with a seed of
//     your own. radiance() gets this same sampler, after your draws for the sample. Afterwards the
//     caller's sampler has made all these draws, and its next number is a new one.
//   - forgets the pixel before: the same arguments give the same answer, whatever came before.
//
// Precision: each channel of the mean is right to 1e-5 of its size. For more than 100 samples, the
// allowed error is larger: samples * 1e-7 of its size. The points that the rays go through are
// right to 1e-5 of the picture's width and height, plus the error of camera_ray. Single precision
// is enough, also for the sum.
//
// May call: the task camera_ray, radiance(), and functions that a header of pt/ defines.
// Threads: it is called from several threads at once, so nothing static may change.
Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler);

}  // namespace pt
