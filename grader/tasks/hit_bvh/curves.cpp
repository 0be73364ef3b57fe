#include "grader/check/language/curve.h"
#include "grader/tasks/hit_bvh/queries.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace hit_bvh_inputs;

// A tree with one triangle more than it has levels.
Case chain_of(int levels) {
  const int n = levels + 1;
  return *with_tree({Shape::left_chain, Shape::right_chain},
                    {.least = n, .most = n, .spheres = false, .max_leaf = 1, .all_of_ray = true});
}

CURVE(hit_bvh, deep_tree) {
  return {.title = "A tree that is a chain",
          .input = "levels of the tree",
          .error = "share of rays with another t than that of all primitives",
          .source =
              "a stack of a fixed size overflows; a function that calls itself needs a frame "
              "for each level",
          .places = {10, 20, 40, 63, 80, 150, 256, 400, 600, 1000, 2000},
          .promised = {{10, 1000}},
          .methods = {{"wrong/stack_of_64", "a stack of 64 nodes"},
                      {"wrong/stack_of_256", "a stack of 256 nodes"},
                      {"right/recursive_unordered", "a function that calls itself"}},
          .statistic = Statistic::mean,
          .cases = 20,
          .measure = [](double levels) {
            const Case c = chain_of(static_cast<int>(levels));
            const Truth truth = truth_of(c.primitives, c.ray);
            const auto hit = ask(c);
            if (!truth.any()) return hit.has_value() ? 1.0 : 0.0;
            return hit && std::abs(hit->t - truth.t()) <= t_error(truth) ? 0.0 : 1.0;
          }};
}

CURVE(hit_bvh, tests_per_ray) {
  return {.title = "What a ray tests in a balanced tree",
          .input = "triangles",
          .error = "boxes and triangles that a ray tests",
          .source = "a tree is as good as the search that leaves parts of it out",
          .places = {10, 30, 100, 300, 1000, 3000},
          .promised = {},
          .methods = {{"wrong/ray_never_shortened", "goes on behind a hit"},
                      {"right/recursive_unordered", "children in any order"},
                      {"wrong/linear_search", "tests every triangle"}},
          .statistic = Statistic::mean,
          .cases = 60,
          .measure = [](double triangles) {
            const int n = static_cast<int>(triangles);
            // The total surface is the same for any number.
            const Case c = *with_tree({Shape::balanced}, {.least = n,
                                                          .most = n,
                                                          .spheres = false,
                                                          .padding = 0,
                                                          .max_leaf = 1,
                                                          .size = 20 / std::sqrt(triangles),
                                                          .all_of_ray = true});
            const Tested log = tested_by(c, false);
            return static_cast<double>(log.boxes.size() + log.triangles.size());
          }};
}

}  // namespace
}  // namespace grader::check
