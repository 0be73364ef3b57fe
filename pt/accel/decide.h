// Asks a primitive itself, in double precision. Internal like simd.h.
#pragma once

#include "pt/accel/exact_hit.h"
#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"

namespace pt {
namespace {

PT_INLINE ExactHit decide(const WideQuery& query, const Ray& ray, std::uint32_t primitive) {
  if (primitive < query.view.triangle_count) return exact_hit(query.triangles[primitive], ray);
  return exact_hit(query.spheres[primitive - query.view.triangle_count], ray);
}

}  // namespace
}  // namespace pt
