// ladder SCENE: the worth of each idea, from the plainest right renderer to the best.
#include "writeup/accuracy/ladder.h"

#include <fmt/format.h>

namespace writeup::accuracy {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_ladder(argc, argv);
  Measuring scene(load_scene(options), {Command::converge, options}, options.bounces, kOfChoices);
  const std::filesystem::path programs = std::filesystem::absolute(argv[0]).parent_path();
  const Ladder ladder = climb(scene, options, programs);
  scene.progress.clear();
  fmt::print("{}", to_text(ladder, options));
  if (!options.out.empty()) write_ladder(ladder, options.out);
  return 0;
}

}  // namespace
}  // namespace writeup::accuracy

int main(int argc, char** argv) {
  return writeup::accuracy::run_program(writeup::accuracy::run, argc, argv);
}
