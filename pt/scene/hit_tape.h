#pragma once

#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"

#include <optional>
#include <vector>

namespace pt {

// The answers of scene.closest, in order, so that the same path can be walked again without tracing
// a ray.
struct HitTape {
  enum class Mode { record, play };
  struct Entry {
    Ray ray;
    std::optional<Hit> hit;
  };

  Mode mode = Mode::record;
  std::vector<Entry> entries;
  std::size_t next = 0;  // to be played
};

// The tape that this thread's calls of scene.closest are on; null: rays are traced as always.
extern constinit thread_local HitTape* hit_tape;

}  // namespace pt
