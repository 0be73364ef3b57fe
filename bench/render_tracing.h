#pragma once

#include "bench/embree.h"
#include "pt/scene/scene.h"

#include <cstdint>
#include <span>

namespace pt {

// How the benchmark's renders trace: set before a render, read by all its threads.
struct RenderTracing {
  const EmbreeScene* embree = nullptr;  // what the task hit_bvh asks; null: the tracer is `wide`
  bool groups = false;                  // shadow rays in groups of eight, not one at a time
};
extern RenderTracing render_tracing;

}  // namespace pt
