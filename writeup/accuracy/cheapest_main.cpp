// cheapest SCENE: the settings that reach an error in the least time, with the tasks linked here.
#include "writeup/accuracy/begin.h"
#include "writeup/accuracy/print.h"

#include <fmt/format.h>

namespace writeup::accuracy {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_cheapest(argc, argv);
  Measuring scene(options, kAllBounces);
  const Answer answer = find_cheapest(scene.study, scene.view, options.error);
  scene.progress.clear();
  fmt::print("{}", to_text(answer, options, scene.loaded.scene));
  if (!options.out.empty()) write_charts(answer, options, options.out);
  return 0;
}

}  // namespace
}  // namespace writeup::accuracy

int main(int argc, char** argv) {
  return writeup::accuracy::run_program(writeup::accuracy::run, argc, argv);
}
