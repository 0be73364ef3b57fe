#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/ray.h"

#include <cstdint>
#include <optional>
#include <span>

#include <embree3/rtcore.h>

namespace pt {

// The triangles and spheres of a scene in Embree 3, built with its defaults on one thread. Single
// precision throughout, as Embree has it.
class EmbreeScene {
 public:
  explicit EmbreeScene(const Primitives& primitives);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  // One ray, by rtcIntersect1 and rtcOccluded1. The normal is interpolated like ours.
  std::optional<Hit> closest(const Primitives& primitives, const Ray& ray) const;
  bool occluded(const Ray& ray) const;

  // The result of rtcIntersect1 for the ray.
  std::optional<Hit> hit_of(const Primitives& primitives, const Ray& ray,
                            const RTCRayHit& query) const;

  // Up to 8 rays, by rtcOccluded8: bit i says whether ray i is blocked.
  std::uint32_t occluded8(std::span<const Ray> rays) const;

  std::size_t bytes() const { return static_cast<std::size_t>(bytes_); }

  RTCScene handle() const { return scene_; }

  // The ray in single precision. It begins and ends a little later and earlier, by 2^-16 of the
  // scene's size: in single precision, the surface on which it starts is not far enough away.
  RTCRay convert(const Ray& ray) const;

 private:
  static bool count_bytes(void* user, ssize_t bytes, bool post);

  RTCDevice device_;
  RTCScene scene_;
  std::uint32_t triangle_count_;
  double margin_ = 0;
  long long bytes_ = 0;  // of memory, by Embree's own count
};

}  // namespace pt
