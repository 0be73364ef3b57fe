#include "bench/queries.h"

#if defined(PT_TINYBVH)

#include <memory>

#define TINYBVH_IMPLEMENTATION
#include <tiny_bvh.h>

namespace pt {
namespace {

struct Tree {
  std::vector<tinybvh::bvhvec4> corners;
  tinybvh::BVH8_CPU bvh;
};

// It has no lower end of a ray, so that end is moved into the origin.
tinybvh::Ray to_tinybvh(const RTCRay& ray) {
  tinybvh::Ray r;
  r.O = {ray.org_x + ray.tnear * ray.dir_x, ray.org_y + ray.tnear * ray.dir_y,
         ray.org_z + ray.tnear * ray.dir_z};
  r.D = {ray.dir_x, ray.dir_y, ray.dir_z};
  r.rD = tinybvh::tinybvh_rcp(r.D);
  r.hit.t = std::min(ray.tfar - ray.tnear, BVH_FAR);
  return r;
}

}  // namespace

const bool has_tinybvh = __builtin_cpu_supports("avx2");

std::function<Queries(const std::vector<Ray>&)> tinybvh(const Primitives& primitives,
                                                        const EmbreeScene& embree) {
  if (!primitives.spheres.empty() || !has_tinybvh) return {};
  const auto tree = std::make_shared<Tree>();
  for (const Triangle& t : primitives.triangles) {
    for (const Vec3& p : {t.p0, t.p1, t.p2}) {
      tree->corners.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y),
                                 static_cast<float>(p.z), 0.0f);
    }
  }
  tree->bvh.Build(tree->corners.data(), static_cast<std::uint32_t>(primitives.triangles.size()));
  return [&, tree](const std::vector<Ray>& rays) {
    std::vector<tinybvh::Ray> converted;
    for (const Ray& ray : rays) converted.push_back(to_tinybvh(embree.convert(ray)));
    return Queries{[&, tree, converted] {
                     double sum = 0;
                     for (tinybvh::Ray ray : converted) {
                       const float end = ray.hit.t;
                       tree->bvh.Intersect(ray);
                       if (!(ray.hit.t < end)) continue;
                       const auto index = static_cast<int>(ray.hit.prim);
                       sum +=
                           sum_of(triangle_hit(primitives, index, ray.hit.t, ray.hit.u, ray.hit.v));
                     }
                     return sum;
                   },
                   [tree, converted] {
                     double sum = 0;
                     for (const tinybvh::Ray& ray : converted) sum += tree->bvh.IsOccluded(ray);
                     return sum;
                   }};
  };
}

}  // namespace pt

#else

namespace pt {

const bool has_tinybvh = false;

std::function<Queries(const std::vector<Ray>&)> tinybvh(const Primitives&, const EmbreeScene&) {
  return {};
}

}  // namespace pt

#endif
