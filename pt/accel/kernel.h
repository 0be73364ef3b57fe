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

// The queries, compiled for one instruction set. Chosen once for each tree; the answers are the
// same bits whichever it is.
struct Kernel {
  const char* name;
  int width;  // children of a node
  WideHit (*closest)(const WideQuery& query, const Ray& ray);
  bool (*occluded)(const WideQuery& query, const Ray& ray);
  std::uint32_t (*occluded_batch)(const WideQuery& query, const Ray* rays, int count);
};

// The one for `name`: "plain" (any machine), "v2", "v3" or "v4" (x86-64-v2, ...); null where
// this program has none of that name, or the machine cannot run it.
const Kernel* find_kernel(const char* name);

// The fastest that the machine can run, or the one that the environment variable FIRSTLIGHT_KERNEL
// names; throws Error where that is none.
const Kernel& best_kernel();

}  // namespace pt
