#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/property.h"
#include "grader/tasks/trace_path/inputs.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using trace_path_inputs::settings_of;

// One bounce has no noise if all lights are points. Further bounces have noise. Statistics judge
// them, and the worst of many random numbers means nothing.
SEARCH(trace_path, one_bounce) {
  return {.title = "one bounce inside a ball with point lights, of any size and brightness",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Room room = *round_room(color(0.01, 1), extreme());
            pt::PathSettings settings = settings_of({*whole(0, 1), 1}, room.direct);
            settings.light_samples = *whole(1, 5);
            settings.survival = *magnitude(1e-3, 1);
            show_case(room);
            pt::Sampler sampler(*sampler_seed());
            const pt::Rgb got = pt::trace_path(room.scene, room.point, settings, sampler);
            const pt::Rgb right = room.sum(1, 1);
            double worst = 0;
            for (int channel = 0; channel < 3; ++channel) {
              worst = std::max(worst, std::abs(got[channel] - right[channel]));
            }
            return worst / room.precision(1, 1);
          }};
}

// Nothing is seen if no bounce is requested, or if every path leaves the scene.
SEARCH(trace_path, no_light) {
  return {.title = "no bounce asked for, or only bounces that no path of the scene has",
          .measure = "any light is broken",
          .badness = [] {
            const bool none = *whole(0, 1) == 0;
            const Room room =
                none ? *round_room(color(0.01, 1), extreme()) : *sunny_wall(color(0.01, 1));
            const int from = *whole(3, 100);
            int to = *whole(0, 1) == 0 ? from - 1 : 100;
            if (none) to = *whole(0, from - 1);
            pt::PathSettings settings = settings_of({from, to}, room.direct);
            settings.survival = *magnitude(1e-3, 1);
            show_case(room);
            pt::Sampler sampler(*sampler_seed());
            const pt::Rgb got = pt::trace_path(room.scene, room.point, settings, sampler);
            return got.r == 0 && got.g == 0 && got.b == 0 ? 0 : kBroken;
          }};
}

}  // namespace
}  // namespace grader::check
