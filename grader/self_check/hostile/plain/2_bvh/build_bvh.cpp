// Allocates without end.
#include "pt/tasks/build_bvh.h"

#include <memory>
#include <vector>

namespace pt {

Bvh build_bvh(std::span<const Box> boxes, int) {
  constexpr int kSize = 10000000;
  std::vector<std::unique_ptr<char[]>> all;
  while (true) {
    all.push_back(std::make_unique_for_overwrite<char[]>(kSize));
    all.back()[boxes.size()] = 1;
  }
}

}  // namespace pt
