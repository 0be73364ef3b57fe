#pragma once

#include "pt/geometry/bvh.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/surface_point.h"
#include "pt/render/render_rows.h"
#include "pt/scene/camera.h"
#include "pt/scene/light.h"
#include "pt/scene/material.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <string_view>
#include <tuple>

namespace grader::wire {

// Both ends: the members of every struct that is sent, and their names: "x, y, z". Encoding, decoding, type codes and the check
// for finite numbers use them. A member that is missing here is a compile error.
template <class Struct>
struct Fields;

template <class T>
concept HasFields = requires(T& value) {
  Fields<T>::of(value);
};

#define FIRSTLIGHT_FIELDS(Struct, ...)                      \
  template <>                                               \
  struct Fields<Struct> {                                   \
    static constexpr std::string_view names = #__VA_ARGS__; \
    static auto of(auto& value) {                           \
      auto& [__VA_ARGS__] = value;                          \
      return std::tie(__VA_ARGS__);                         \
    }                                                       \
  }

FIRSTLIGHT_FIELDS(pt::Vec3, x, y, z);
FIRSTLIGHT_FIELDS(pt::Rgb, r, g, b);
FIRSTLIGHT_FIELDS(pt::Frame, x, y, z);
FIRSTLIGHT_FIELDS(pt::Ray, origin, direction, t_min, t_max, source_triangle);
FIRSTLIGHT_FIELDS(pt::Interval, min, max);
FIRSTLIGHT_FIELDS(pt::Triangle, p0, p1, p2, n0, n1, n2);
FIRSTLIGHT_FIELDS(pt::Sphere, center, radius);
FIRSTLIGHT_FIELDS(pt::Box, min, max);
FIRSTLIGHT_FIELDS(pt::SurfaceHit, t, n);
FIRSTLIGHT_FIELDS(pt::Hit, t, n, primitive);
FIRSTLIGHT_FIELDS(pt::BvhNode, box, left, right, first, count);
FIRSTLIGHT_FIELDS(pt::Bvh, nodes, order);
FIRSTLIGHT_FIELDS(pt::Primitives, triangles, spheres);
FIRSTLIGHT_FIELDS(pt::SurfacePoint, p, n, geometric_normal, frame, wo, albedo, emission, triangle,
                  scale);
FIRSTLIGHT_FIELDS(pt::Camera, position, camera_to_world, hfov_deg, vfov_deg, near_clip, far_clip);
FIRSTLIGHT_FIELDS(pt::Material, name, albedo, emission, unsupported, behind);
FIRSTLIGHT_FIELDS(pt::RectangleLight, center, u, v, n, radiance, as_in_cs184);
FIRSTLIGHT_FIELDS(pt::SphereLight, center, radius, radiance);
FIRSTLIGHT_FIELDS(pt::MeshLight::Face, p0, p1, p2);
FIRSTLIGHT_FIELDS(pt::MeshLight, faces, area_up_to, radiance);
FIRSTLIGHT_FIELDS(pt::PointLight, position, intensity);
FIRSTLIGHT_FIELDS(pt::DirectionalLight, direction, irradiance);
FIRSTLIGHT_FIELDS(pt::AmbientLight, radiance);
FIRSTLIGHT_FIELDS(pt::PathSettings, light_samples, direct, survival, from, to, show_normals);
FIRSTLIGHT_FIELDS(pt::AdaptiveSettings, max_samples, batch, tolerance);
FIRSTLIGHT_FIELDS(pt::PixelEstimate, mean, samples);
FIRSTLIGHT_FIELDS(pt::BsdfSample, wi, f, pdf);
FIRSTLIGHT_FIELDS(pt::BounceRange, from, to);
FIRSTLIGHT_FIELDS(pt::RowsRequest, first_row, rows, samples, adaptive, seed, ranges, only);
FIRSTLIGHT_FIELDS(pt::TestCount, boxes, triangles, spheres);
FIRSTLIGHT_FIELDS(pt::RowsMeasured, variance_y, boxes, tests, not_finite, apart);
FIRSTLIGHT_FIELDS(pt::PictureRows, mean, counts, measured);

// The largest value of an enum; the smallest is 0.
template <class Enum>
inline constexpr int kLargest = -1;
template <>
inline constexpr int kLargest<pt::PathSettings::Direct> =
    static_cast<int>(pt::PathSettings::Direct::lights);
template <>
inline constexpr int kLargest<pt::Engine> = static_cast<int>(pt::Engine::wide);

}  // namespace grader::wire
