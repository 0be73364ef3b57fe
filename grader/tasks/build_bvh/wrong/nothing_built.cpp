#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <numeric>

namespace pt {

Bvh build_bvh(std::span<const Box>, int) { return {}; }

}  // namespace pt
