#include "grader/check/generators/generators.h"
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/property.h"
#include "grader/tasks/direct_hemisphere/inputs.h"
#include "pt/tasks/direct_hemisphere.h"

namespace grader::check {
namespace {

SEARCH(direct_hemisphere, closed_room) {
  return {.title = "a patch in a closed room of light, at any scale and far from the origin",
          .measure = "a black estimate is broken: the ray met its own surface, or left the room",
          .badness = [] {
            SceneMaker maker(*pose(1e6, 1e4));
            direct_hemisphere_inputs::glowing_walls(maker, pt::gray(1));  // the floor is the patch
            maker.patch(pt::gray(0.5), *direction_above_at(magnitude(1e-3, 1)), *whole(0, 1) == 1);
            const Situation s = maker.done();
            show_case(s);
            pt::Sampler sampler(*sampler_seed());
            const double got = pt::direct_hemisphere(s.scene, s.point, 1, sampler).r;
            return got > 0 ? 0 : kBroken;
          }};
}

}  // namespace
}  // namespace grader::check
