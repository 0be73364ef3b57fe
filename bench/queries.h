#pragma once

#include "bench/embree.h"
#include "pt/accel/wide_bvh.h"

#include <functional>
#include <optional>
#include <vector>

namespace pt {

// The queries of one engine for the same rays, in the form that it needs. Each returns the sum of all numbers that it
// found, so that no engine can leave out a part of an answer.
struct Queries {
  std::function<double()> closest;
  std::function<double()> occluded;
};

// The primitives, the tree and the rays must outlive the queries.
Queries queries_of(const WideBvh& bvh, const Primitives& primitives, const std::vector<Ray>& rays);
Queries queries_of(const EmbreeScene& embree, const Primitives& primitives,
                   const std::vector<Ray>& rays);

// True if the program was built with tinybvh (docs/performance.md) and the machine can run it.
extern const bool has_tinybvh;

// Makes queries of tinybvh's BVH8_CPU from rays that Embree's scene has converted. Empty without
// tinybvh, and for spheres, which it does not have.
std::function<Queries(const std::vector<Ray>&)> tinybvh(const Primitives& primitives,
                                                        const EmbreeScene& embree);

inline double sum_of(const std::optional<Hit>& hit) {
  return hit ? hit->t + hit->primitive + hit->n.x + hit->n.y + hit->n.z : 0;
}

}  // namespace pt
