// Loops for ever.
#include "pt/tasks/hit_box.h"

namespace pt {

std::optional<Interval> hit_box(const Box&, const Ray&) {
  for (volatile int i = 0;; i = i + 1) {
  }
}

}  // namespace pt
