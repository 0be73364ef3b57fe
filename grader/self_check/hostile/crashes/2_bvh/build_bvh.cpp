// Splits the same boxes for ever: nothing has a middle that two halves would share.
#include "pt/tasks/build_bvh.h"

#include <vector>

namespace pt {

namespace {

int build(Bvh& bvh, std::span<const Box> boxes, std::vector<int>& some) {
  double sum = 0;
  for (const int i : some) sum += boxes[i].center().x;
  volatile double kept[16] = {sum};
  const int left = build(bvh, boxes, some);
  return left + static_cast<int>(kept[0]);
}

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int) {
  Bvh bvh;
  std::vector<int> all(boxes.size());
  bvh.order.assign(boxes.size(), build(bvh, boxes, all));
  return bvh;
}

}  // namespace pt
