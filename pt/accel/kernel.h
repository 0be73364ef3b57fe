#pragma once

#include "pt/accel/exact_hit.h"
#include "pt/accel/wide_tree.h"

#include <cstdint>

namespace pt {

// The answer to a query: `primitive` is kNothing if there is no hit.
struct WideHit {
  ExactHit hit;
  std::uint32_t primitive;
};

// The queries, compiled for one instruction set. It is chosen once per tree, and does not change a
// bit of the answers.
struct Kernel {
  const char* name;
  int width;  // children of a node
  WideHit (*closest)(const WideQuery& query, const Ray& ray);
  bool (*occluded)(const WideQuery& query, const Ray& ray);
  std::uint32_t (*occluded_batch)(const WideQuery& query, const Ray* rays, int count);
};

// The kernel called `name`: "plain" (any machine), "v2", "v3" or "v4" (x86-64-v2, ...). Null if
// this program has no such kernel, or the machine cannot run it.
const Kernel* find_kernel(const char* name);

// The fastest kernel that the machine can run, or the kernel that the environment variable
// FIRSTLIGHT_KERNEL names. Throws Error if there is no such kernel.
const Kernel& best_kernel();

}  // namespace pt
