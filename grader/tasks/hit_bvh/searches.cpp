#include "grader/check/language/bad_inputs.h"
#include "grader/check/mocks/counting.h"
#include "grader/tasks/hit_bvh/queries.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace hit_bvh_inputs;

SEARCH(hit_bvh, nearest) {
  return {.title = "the nearest hit in trees of any shape, against every primitive in turn",
          .measure = "1 is what the contract allows; a hit that is not there is broken",
          .badness = [] {
            const Wanted wanted{.copies = true, .any_scale = true};
            const Case c = *with_tree({Shape::balanced, Shape::random, Shape::chain,
                                       Shape::left_chain, Shape::right_chain, Shape::leaf},
                                      wanted);
            show_case(c);
            const Truth truth = truth_of(c.primitives, c.ray);
            if (!truth.is_clear) return 0.0;
            forget_tests();  // the tests of millions of queries would fill the memory
            const auto hit = ask(c);
            const bool any = pt::occluded_bvh(c.bvh, c.primitives, c.ray);
            if (any != truth.any() || hit.has_value() != truth.any()) return kBroken;
            return hit ? std::abs(hit->t - truth.t()) / t_error(truth) : 0.0;
          }};
}

}  // namespace
}  // namespace grader::check
