#pragma once

#include "writeup/measure/message.h"

#include <cstdint>
#include <functional>

// The subject of a worker's measurement: one case of one task, as it is linked here, on inputs of its own.
// The inputs are the same in every worker.

namespace writeup::measure {

struct Subject {
  int calls = 0;               // that a pass makes
  std::function<void()> pass;  // calls the task on all inputs
  std::function<Found(std::uint64_t seed)> find;
};

// The subjects, in the order of the cases in tasks.h.
Subject camera_rays();
Subject triangles();
Subject spheres();
Subject boxes();
Subject tree_builds(int of_cases);
Subject tree_queries(int of_cases);
Subject diffuse_samples();
Subject direct_light(bool by_lights, int of_cases);
Subject paths();
Subject pixels(bool adaptive, int of_cases);

}  // namespace writeup::measure
