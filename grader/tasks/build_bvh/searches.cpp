#include "grader/check/language/bad_inputs.h"
#include "grader/tasks/build_bvh/walk.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace build_bvh_inputs;

const std::vector<Kind> kAll{Kind::scattered, Kind::clustered,   Kind::points,   Kind::flat,
                             Kind::nested,    Kind::line,        Kind::halving,  Kind::both_ends,
                             Kind::identical, Kind::same_center, Kind::in_piles, Kind::lattice,
                             Kind::diagonal};

SEARCH(build_bvh, levels) {
  return {.title = "levels of a tree with one box in a leaf, of all kinds of boxes at any scale",
          .measure = "1 is a tree that halves its boxes at each level",
          .badness = [] {
            Input input = *boxes_of(kAll, 8, 500);
            input.max_leaf = 1;
            show_case(input);
            const pt::Bvh bvh = built(input.boxes, input.max_leaf);
            for (const int i : walk_from_root(bvh)) {
              const pt::BvhNode& node = bvh.nodes[i];
              for (int k = node.first; k < node.first + node.count; ++k) {
                const int primitive = primitive_at(bvh, k, input.boxes.size());
                if (primitive < 0 || !contains(node.box, input.boxes[primitive])) return kBroken;
              }
            }
            return depth(bvh) / std::ceil(std::log2(static_cast<double>(input.boxes.size())));
          }};
}

}  // namespace
}  // namespace grader::check
