#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/ray.h"

#include <cstdint>
#include <optional>
#include <span>

#include <embree3/rtcore.h>

namespace pt {

// A hit of a triangle at t, with the weights of its second and third corner, and the normal interpolated like ours.
Hit triangle_hit(const Primitives& primitives, int primitive, double t, double b1, double b2);

// The triangles and spheres of a scene in Embree 3, built on one thread. All numbers are in single
// precision, as in Embree. By default nothing stops a ray from slipping through an edge; the robust mode does.
class EmbreeScene {
 public:
  explicit EmbreeScene(const Primitives& primitives, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  // Queries for one ray, with rtcIntersect1 and rtcOccluded1.
  std::optional<Hit> closest(const Primitives& primitives, const Ray& ray) const;
  bool occluded(const Ray& ray) const;

  // The result of rtcIntersect1 for the ray.
  std::optional<Hit> hit_of(const Primitives& primitives, const Ray& ray,
                            const RTCRayHit& query) const;

  // A query for up to 8 rays, with rtcOccluded8: bit i says whether ray i is blocked.
  std::uint32_t occluded8(std::span<const Ray> rays) const;

  std::size_t bytes() const { return static_cast<std::size_t>(bytes_); }

  RTCScene handle() const { return scene_; }

  // Returns the ray in single precision, shortened at both ends by 2^-16 of the scene's size:
  // otherwise it could hit the surface on which it starts.
  RTCRay convert(const Ray& ray) const;

 private:
  static bool count_bytes(void* user, ssize_t bytes, bool post);

  RTCDevice device_;
  RTCScene scene_;
  std::uint32_t triangle_count_;
  double margin_ = 0;
  long long bytes_ = 0;  // of memory, as Embree counts them
};

}  // namespace pt
