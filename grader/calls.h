#pragma once

#include "pt/render/radiance.h"
#include "pt/render/render_rows.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/build_bvh.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/estimate_pixel.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"
#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"
#include "pt/tasks/trace_path.h"

#include <array>
#include <cstdint>
#include <string_view>

// The one table of what crosses the border between judge and worker: the functions of every task,
// as their contracts declare them. A line that differs from a contract does not compile. CALL is a
// pure function, DRAW one that also takes a Sampler& (last), so that it can be repeated.
//   (result, function, (parameters), (their names))

#define FIRSTLIGHT_CALLS_estimate_pixel(CALL, DRAW)                                          \
  DRAW(Rgb, estimate_pixel, (const View& view, int x, int y, int samples, Sampler& sampler), \
       (view, x, y, samples, sampler))
#define FIRSTLIGHT_CALLS_camera_ray(CALL, DRAW) \
  CALL(Ray, camera_ray, (const Camera& camera, double x, double y), (camera, x, y))
#define FIRSTLIGHT_CALLS_hit_triangle(CALL, DRAW)                                           \
  CALL(std::optional<SurfaceHit>, hit_triangle, (const Triangle& triangle, const Ray& ray), \
       (triangle, ray))
#define FIRSTLIGHT_CALLS_hit_sphere(CALL, DRAW) \
  CALL(std::optional<SurfaceHit>, hit_sphere, (const Sphere& sphere, const Ray& ray), (sphere, ray))
#define FIRSTLIGHT_CALLS_build_bvh(CALL, DRAW) \
  CALL(Bvh, build_bvh, (std::span<const Box> boxes, int max_leaf), (boxes, max_leaf))
#define FIRSTLIGHT_CALLS_hit_box(CALL, DRAW) \
  CALL(std::optional<Interval>, hit_box, (const Box& box, const Ray& ray), (box, ray))
#define FIRSTLIGHT_CALLS_hit_bvh(CALL, DRAW)                                                   \
  CALL(std::optional<Hit>, hit_bvh,                                                            \
       (const Bvh& bvh, const Primitives& primitives, const Ray& ray), (bvh, primitives, ray)) \
  CALL(bool, occluded_bvh, (const Bvh& bvh, const Primitives& primitives, const Ray& ray),     \
       (bvh, primitives, ray))
#define FIRSTLIGHT_CALLS_diffuse_bsdf(CALL, DRAW)                            \
  CALL(Rgb, diffuse_f, (Rgb albedo, Vec3 wo, Vec3 wi), (albedo, wo, wi))     \
  DRAW(BsdfSample, diffuse_sample, (Rgb albedo, Vec3 wo, Sampler & sampler), \
       (albedo, wo, sampler))                                                \
  CALL(double, diffuse_pdf, (Vec3 wo, Vec3 wi), (wo, wi))
#define FIRSTLIGHT_CALLS_direct_hemisphere(CALL, DRAW)                                 \
  DRAW(Rgb, direct_hemisphere,                                                         \
       (const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler), \
       (scene, point, samples, sampler))
#define FIRSTLIGHT_CALLS_direct_lights(CALL, DRAW)                                     \
  DRAW(Rgb, direct_lights,                                                             \
       (const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler), \
       (scene, point, samples, sampler))
#define FIRSTLIGHT_CALLS_trace_path(CALL, DRAW)                                      \
  DRAW(Rgb, trace_path,                                                              \
       (const Scene& scene, const SurfacePoint& point, const PathSettings& settings, \
        Sampler& sampler),                                                           \
       (scene, point, settings, sampler))
#define FIRSTLIGHT_CALLS_adaptive_pixel(CALL, DRAW)                                          \
  DRAW(PixelEstimate, adaptive_pixel,                                                        \
       (const View& view, int x, int y, const AdaptiveSettings& settings, Sampler& sampler), \
       (view, x, y, settings, sampler))

// Not a task, but two tasks call it.
#define FIRSTLIGHT_CALLS_radiance(CALL, DRAW)                                                \
  DRAW(Rgb, radiance,                                                                        \
       (const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler), \
       (scene, ray, settings, sampler))

// Not a task either: the pictures that the judge looks at.
#define FIRSTLIGHT_CALLS_render_rows(CALL, DRAW) \
  CALL(PictureRows, render_rows, (const View& view, const RowsRequest& request), (view, request))

// TASK(slug, CALL, DRAW) for each task, in the order of grader/tasks.json, which self_check/tasks_test
// compares with it.
#define FIRSTLIGHT_TASKS(TASK, CALL, DRAW) \
  TASK(estimate_pixel, CALL, DRAW)         \
  TASK(camera_ray, CALL, DRAW)             \
  TASK(hit_triangle, CALL, DRAW)           \
  TASK(hit_sphere, CALL, DRAW)             \
  TASK(build_bvh, CALL, DRAW)              \
  TASK(hit_box, CALL, DRAW)                \
  TASK(hit_bvh, CALL, DRAW)                \
  TASK(diffuse_bsdf, CALL, DRAW)           \
  TASK(direct_hemisphere, CALL, DRAW)      \
  TASK(direct_lights, CALL, DRAW)          \
  TASK(trace_path, CALL, DRAW)             \
  TASK(adaptive_pixel, CALL, DRAW)

// The rows of one task whose slug is itself a macro.
#define FIRSTLIGHT_JOIN(a, b) a##b
#define FIRSTLIGHT_CALLS_OF(slug) FIRSTLIGHT_JOIN(FIRSTLIGHT_CALLS_, slug)

// All rows.
#define FIRSTLIGHT_ROWS(slug, CALL, DRAW) FIRSTLIGHT_CALLS_OF(slug)(CALL, DRAW)
#define FIRSTLIGHT_CALLS(CALL, DRAW)            \
  FIRSTLIGHT_TASKS(FIRSTLIGHT_ROWS, CALL, DRAW) \
  FIRSTLIGHT_CALLS_radiance(CALL, DRAW) FIRSTLIGHT_CALLS_render_rows(CALL, DRAW)

// For the body of a file that defines Repeated (grader/check/repeat.h): makes it for one task.
#define FIRSTLIGHT_NO_ROW(result, function, parameters, names)
#define FIRSTLIGHT_REPEATED_ROW(result, function, parameters, names) \
  template struct grader::check::Repeated<&pt::function>;
#define FIRSTLIGHT_REPEATED(slug) \
  FIRSTLIGHT_CALLS_OF(slug)(FIRSTLIGHT_NO_ROW, FIRSTLIGHT_REPEATED_ROW)

namespace grader::wire {

#define FIRSTLIGHT_NAME(result, function, parameters, names) function,
enum class Function : std::uint32_t { FIRSTLIGHT_CALLS(FIRSTLIGHT_NAME, FIRSTLIGHT_NAME) };
#undef FIRSTLIGHT_NAME

#define FIRSTLIGHT_NAME(result, function, parameters, names) #function,
inline constexpr std::array kFunctionNames{FIRSTLIGHT_CALLS(FIRSTLIGHT_NAME, FIRSTLIGHT_NAME)};
#undef FIRSTLIGHT_NAME

#define FIRSTLIGHT_NAME(slug, CALL, DRAW) std::string_view(#slug),
inline constexpr std::array kTasks{FIRSTLIGHT_TASKS(FIRSTLIGHT_NAME, , )};
#undef FIRSTLIGHT_NAME

// The number of a function: kFunction<&pt::hit_box> is Function::hit_box.
template <auto Pointer>
inline constexpr Function kFunction{};
#define FIRSTLIGHT_NAME(result, function, parameters, names) \
  template <>                                                \
  inline constexpr Function kFunction<&pt::function> = Function::function;
FIRSTLIGHT_CALLS(FIRSTLIGHT_NAME, FIRSTLIGHT_NAME)
#undef FIRSTLIGHT_NAME

}  // namespace grader::wire
