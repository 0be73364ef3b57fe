#include "grader/check/generators/generators.h"
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/property.h"
#include "grader/check/scenes/scenes.h"
#include "pt/tasks/direct_lights.h"

#include <cmath>

namespace grader::check {
namespace {

SEARCH(direct_lights, without_noise) {
  return {.title = "point lights and suns above a patch, at any scale and far from the origin",
          .measure = "1 is what the contract allows",
          .badness = [] {
            SceneMaker maker(*pose(1e6, 1e4));
            const int lights = *whole(1, 6);
            for (int i = 0; i < lights; ++i) {
              const pt::Vec3 towards = *direction_above_at(magnitude(1e-3, 1));
              if (*whole(0, 1) == 0) {
                maker.directional_light(towards, pt::gray(*brightness()));
              } else {
                maker.point_light(*magnitude(1e-1, 1e2) * towards, pt::gray(*brightness()));
              }
            }
            const bool behind = *whole(0, 1) == 1;
            maker.patch(pt::gray(*real(0.01, 1)), *direction_above_at(magnitude(1e-3, 1)), behind);
            const Situation s = maker.done();
            show_case(s);
            pt::Sampler sampler(*sampler_seed());
            const double got = pt::direct_lights(s.scene, s.point, 1, sampler).r;
            return std::abs(got / s.expected.r - 1) / kColorPrecision;
          }};
}

}  // namespace
}  // namespace grader::check
