#include "measure/calls/subject.h"
#include "measure/calls/trees.h"

#include <array>

namespace measure::calls {

namespace {

constexpr std::array kLeaves{1, 2, 4, 8, 16};

}  // namespace

Subject measure_build_bvh(int of_case) {
  const int leaf = kLeaves.at(of_case);
  return {
      1,
      [leaf] { sink = static_cast<double>(pt::build_bvh(tree_inputs().boxes, leaf).nodes.size()); },
      [leaf](std::uint64_t) { return query(pt::build_bvh(tree_inputs().boxes, leaf), false); }};
}

}  // namespace measure::calls
