// ladder SCENE: measures the worth of each idea, from the simplest right renderer to the best.
#include "measure/scene/ladder.h"
#include "pt/end_of_program.h"

#include <fmt/format.h>

namespace measure::scene {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_ladder(argc, argv);
  Measuring scene(load_scene(options), options, options.bounces, kOfChoices);
  const Ladder ladder = climb(scene, options, {argv, argv + argc});
  scene.progress.clear();
  fmt::print("{}", to_text(ladder, options));
  if (!options.out.empty()) write_ladder(ladder, options);
  return 0;
}

}  // namespace
}  // namespace measure::scene

int main(int argc, char** argv) {
  return pt::run_program([&] { return measure::scene::run(argc, argv); });
}
