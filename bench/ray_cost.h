#pragma once

#include "pt/accel/kernel.h"

namespace pt {

// The steps of a query for the nearest hit, each with all that comes before it: the cost of a step
// is its time less that of the step before. The results depend on all that the steps compute.
struct RaySteps {
  WideHit (*call)(const WideQuery& query, const Ray& ray);      // reads the ray, copies a result
  WideHit (*to_frame)(const WideQuery& query, const Ray& ray);  // also changes to the tree's frame
  WideHit (*prepared)(const WideQuery& query, const Ray& ray);
  WideHit (*found)(const WideQuery& query, const Ray& ray);  // all but the decision that ends it
};

// The steps of find_kernel(name), where this program has it.
const RaySteps* find_ray_steps(const char* name);

}  // namespace pt
