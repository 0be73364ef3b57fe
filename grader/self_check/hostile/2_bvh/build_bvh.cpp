// Allocates without end.
#include "pt/tasks/build_bvh.h"

#include <vector>

namespace pt {

Bvh build_bvh(std::span<const Box> boxes, int) {
  std::vector<std::vector<Box>> all;
  while (true) all.emplace_back(100000 + boxes.size());
}

}  // namespace pt
