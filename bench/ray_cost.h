#pragma once

#include "pt/accel/kernel.h"

namespace pt {

// The steps of a query for the nearest hit. Each includes the steps before it, so the cost of a step
// is its time minus that of the step before. The results depend on everything that the steps compute.
struct RaySteps {
  WideHit (*call)(const WideQuery& query, const Ray& ray);      // reads the ray, copies a result
  WideHit (*to_frame)(const WideQuery& query, const Ray& ray);  // also changes to the tree's frame
  WideHit (*prepared)(const WideQuery& query, const Ray& ray);
  WideHit (*found)(const WideQuery& query, const Ray& ray);  // everything but the last decision
};

// The steps of find_kernel(name); null if this program does not have it.
const RaySteps* find_ray_steps(const char* name);

}  // namespace pt
