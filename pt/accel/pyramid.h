// The rays of a group as one: the pyramid around them. Internal like simd.h.
#pragma once

#include "pt/accel/block_test.h"
#include "pt/accel/float_ray.h"
#include "pt/accel/sphere_test.h"

namespace pt {
namespace {

// The number of rays that are traced together.
constexpr int kGroup = 8;

// Rays from one point. Their directions are all within `spread` of `middle`.
struct Pyramid {
  float origin[4];
  float middle[4];
  float spread[4];
  float t_max;
  float longest;  // as in FloatRay: the largest
  float edge_error;
  float plane_error;  // of all
  std::uint32_t source_triangle;
  Lanes3<kGroup> direction;  // of each ray; unused lanes repeat the first
};

// Returns whether the rays differ only in their direction.
PT_INLINE bool are_alike(const Ray* rays, int count) {
  const auto differ = [](double a, double b) __attribute__((always_inline)) {
    return __builtin_bit_cast(std::uint64_t, a) ^ __builtin_bit_cast(std::uint64_t, b);
  };
  const Ray& first = rays[0];
  std::uint64_t other = 0;
  for (int i = 1; i < count; ++i) {
    other |= differ(rays[i].origin.x, first.origin.x) | differ(rays[i].origin.y, first.origin.y) |
             differ(rays[i].origin.z, first.origin.z) | differ(rays[i].t_min, first.t_min) |
             differ(rays[i].t_max, first.t_max);
    other |= static_cast<std::uint64_t>(rays[i].source_triangle ^ first.source_triangle);
  }
  return other == 0;
}

// The pyramid around rays that differ only in their direction.
PT_INLINE Pyramid pyramid_of(const FloatRay* r, int count) {
  Floats4 low = load<4>(r[0].direction), high = low;
  Pyramid pyramid;
  for (int i = 0; i < kGroup; ++i) {
    const FloatRay& ray = r[i < count ? i : 0];
    low = min<4>(low, load<4>(ray.direction));
    high = max<4>(high, load<4>(ray.direction));
    pyramid.direction.x[i] = ray.direction[0];
    pyramid.direction.y[i] = ray.direction[1];
    pyramid.direction.z[i] = ray.direction[2];
  }
  const Floats4 longest = max<4>(magnitude<4>(low), magnitude<4>(high));
  store<4>(pyramid.origin, load<4>(r[0].origin));
  store<4>(pyramid.middle, 0.5f * (low + high));
  store<4>(pyramid.spread, 0.5f * (high - low) + 4 * kUnit * longest);
  pyramid.t_max = r[0].t_max;
  pyramid.longest = largest(longest);
  pyramid.plane_error = r[0].plane_error;
  pyramid.edge_error = pyramid.plane_error * pyramid.longest;
  pyramid.source_triangle = r[0].source_triangle;
  return pyramid;
}

// The triangles of the block that some ray of the pyramid may meet, and all spheres: test_block for all directions
// within it, each volume a range. With g = c x e an edge's volume is g . d, so for a ray of the
// pyramid it is g . middle, give or take |g| . spread. Twice the errors of float_ray.h cover the
// rounding of the ranges. kWalls: a scene of one block, whose planes are mostly out of reach.
template <bool kSpheres, bool kWalls>
PT_INLINE std::uint32_t test_block(const Block& b, const Pyramid& pyramid) {
  constexpr int W = kWidth;
  const Lanes3<W> middle = splat3<W>(pyramid.middle), spread = splat3<W>(pyramid.spread);
  const auto range = [&](const Lanes3<W>& g) __attribute__((always_inline)) {
    const Floats<W> center = dot<W>(g, middle), margin = dot<W>(magnitude<W>(g), spread);
    return Range<W>{center - margin, center + margin};
  };
  std::uint32_t spheres = 0;
  for (int i = 0; kSpheres && i < W && is_sphere(b, i); ++i) spheres |= 1u << i;
  const Lanes3<W> c = rows(b.p0) - splat3<W>(pyramid.origin), n = normals(b);
  const Range<W> det = range(n);
  const Floats<W> volume = dot<W>(c, n);
  const Floats<W> above = max<W>(det.high, Floats<W>{}) * pyramid.t_max - volume;
  const Floats<W> below = volume - min<W>(det.low, Floats<W>{}) * pyramid.t_max;
  const Floats<W> error = 2 * pyramid.plane_error * load<W>(b.area);
  const std::uint32_t reached = less_equal<W>(Floats<W>{}, min<W>(above, below) + error) &
                                not_equal<W>(b.primitive, pyramid.source_triangle);
  if (kWalls && reached == 0) return spheres;

  const Lanes3<W> over_e2 = cross<W>(c, rows(b.e2)), over_e1 = cross<W>(c, rows(b.e1));
  const Range<W> u = range(over_e2), v = range(over_e1), w = range(n - over_e2 - over_e1);
  const Floats<W> least = min<W>(min<W>(u.high, v.high), w.high);
  const Floats<W> most = max<W>(max<W>(u.low, v.low), w.low);
  const Floats<W> inside = max<W>(least, -most);
  const Floats<W> edge_error = 2 * pyramid.edge_error * load<W>(b.size);
  return spheres | (reached & less_equal<W>(Floats<W>{}, inside + edge_error));
}

// Tests one primitive of the block against all rays of the pyramid, which begin and end like `r`.
template <bool kSpheres>
PT_INLINE Verdict<kGroup> test_slot(const Block& b, int slot, const Pyramid& pyramid,
                                    const FloatRay& r) {
  constexpr int W = kGroup;
  const auto all = [&](const float(&m)[3][kWidth]) __attribute__((always_inline)) {
    return Lanes3<W>{splat<W>(m[0][slot]), splat<W>(m[1][slot]), splat<W>(m[2][slot])};
  };
  if (kSpheres && is_sphere(b, slot)) {
    return test_spheres<W>(all(b.p0) - splat3<W>(pyramid.origin), splat<W>(b.e1[0][slot]),
                           pyramid.direction, splat<W>(pyramid.edge_error),
                           splat<W>(pyramid.longest), splat<W>(r.t_min), splat<W>(r.t_max));
  }
  return test_pairs<W>({all(b.p0) - splat3<W>(pyramid.origin), pyramid.direction, splat<W>(r.t_min),
                        splat<W>(r.t_max), all(b.e1), all(b.e2), cross<W>(all(b.e1), all(b.e2)),
                        splat<W>(pyramid.edge_error * b.size[slot]),
                        splat<W>(pyramid.plane_error * b.area[slot])});
}

}  // namespace
}  // namespace pt
