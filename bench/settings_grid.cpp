// settings_grid SCENE [options of cheapest]: tests whether `cheapest` finds the cheapest settings. Measures sixty
// other settings one by one, and says how much faster the best of them is. All are measured in turns.
#include "measure/scene/answer.h"
#include "measure/scene/begin.h"
#include "pt/end_of_program.h"

#include <fmt/format.h>

namespace measure::scene {
namespace {

constexpr int kLightSamples[] = {1, 2, 4, 8};
constexpr double kSurvivals[] = {0.3, 0.5, 0.7, 0.85, 1.0};
constexpr int kBounces = 3;  // how many: the number found, and its neighbours

struct Setting {
  Way way;
  int light_samples = 1;
};

// Processor time per pixel until this setting reaches the error, measured without the model of the
// others; 0 if it cannot reach it.
double seconds_to(Study& study, const Setting& setting, double error) {
  const Tried tried = study.try_out(setting.way, {setting.light_samples})[0];
  const double left = error * error - study.bias2_at(setting.way.bounces);
  return left > 0 ? tried.variance.value / left * tried.seconds.value : 0;
}

int run(int argc, const char* const* argv) {
  const Options options = parse_cheapest(argc, argv);
  Measuring scene(load_scene(options), options, kAllBounces);
  Study& study = scene.study;
  const Answer answer = find_cheapest(study, scene.view, options);
  const int bounces = answer.best.way.bounces;
  const Setting found{answer.best.way, answer.best.choice->light_samples};
  fmt::print("bounces,survival,light_samples,seconds_beside_those_found\n");
  double least = 1;
  for (int m = std::max(1, bounces - 1); m < std::max(1, bounces - 1) + kBounces; ++m) {
    for (const double survival : kSurvivals) {
      for (const int l : kLightSamples) {
        const Setting setting{{pt::PathSettings::Direct::lights, m, survival}, l};
        const double before = seconds_to(study, found, options.error);
        const double seconds = seconds_to(study, setting, options.error);
        const double after = seconds_to(study, found, options.error);
        const double beside = seconds / ((before + after) / 2);
        if (seconds > 0) least = std::min(least, beside);
        fmt::print("{},{:g},{},{:.3f}\n", m, survival, l, beside);
      }
    }
  }
  scene.progress.clear();
  fmt::print("found: m {}, survival {:g}, l {}; the best of the grid takes {:.3f} of its time\n",
             bounces, found.way.survival, found.light_samples, least);
  return 0;
}

}  // namespace
}  // namespace measure::scene

int main(int argc, char** argv) {
  return pt::run_program([&] { return measure::scene::run(argc, argv); });
}
