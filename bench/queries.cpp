#include "bench/queries.h"

namespace pt {

Queries queries_of(const WideBvh& bvh, const Primitives& primitives, const std::vector<Ray>& rays) {
  return {[&] {
            double sum = 0;
            for (const Ray& ray : rays) sum += sum_of(bvh.closest(primitives, ray));
            return sum;
          },
          [&] {
            double sum = 0;
            for (const Ray& ray : rays) sum += bvh.occluded(primitives, ray);
            return sum;
          }};
}

// Rays are converted beforehand, and copied because a query writes into them.
Queries queries_of(const EmbreeScene& embree, const Primitives& primitives,
                   const std::vector<Ray>& rays) {
  std::vector<RTCRay> converted;
  for (const Ray& ray : rays) converted.push_back(embree.convert(ray));
  return {[&, converted] {
            double sum = 0;
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            for (std::size_t i = 0; i < rays.size(); ++i) {
              RTCRayHit query;
              query.ray = converted[i];
              query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
              rtcIntersect1(embree.handle(), &context, &query);
              sum += sum_of(embree.hit_of(primitives, rays[i], query));
            }
            return sum;
          },
          [&, converted] {
            double sum = 0;
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            for (RTCRay ray : converted) {
              rtcOccluded1(embree.handle(), &context, &ray);
              sum += ray.tfar < 0;
            }
            return sum;
          }};
}

}  // namespace pt
