#pragma once

#include "bench/embree.h"
#include "pt/scene/scene.h"

#include <cstdint>
#include <span>

namespace pt {

// The way in which the benchmark's renders trace: set before a render, read by all its threads.
struct RenderTracing {
  const EmbreeScene* embree = nullptr;  // called by the task hit_bvh; null: the tracer is `wide`
  bool groups = false;                  // shadow rays in groups of eight, not one at a time
};
extern RenderTracing render_tracing;

}  // namespace pt
