#include "measure/calls/subject.h"
#include "measure/calls/trees.h"

#include <memory>

namespace measure::calls {

namespace {

constexpr int kLeaf = 4;  // as in ./run render

}  // namespace

Subject measure_hit_bvh(int of_case) {
  const bool any = of_case == 1;
  const auto bvh = std::make_shared<const pt::Bvh>(pt::build_bvh(tree_inputs().boxes, kLeaf));
  const auto pass = [bvh, any] {
    const TreeInputs& all = tree_inputs();
    double sum = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
      sum += any ? occluded_bvh(*bvh, all.primitives, all.shadow_rays[i])
                 : hit_bvh(*bvh, all.primitives, all.rays[i]).has_value();
    }
    sink = sum;
  };
  return {kRays, pass, [bvh, any](std::uint64_t) { return query(*bvh, any); }};
}

}  // namespace measure::calls
