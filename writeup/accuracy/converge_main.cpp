// converge SCENE: error against samples, seconds and rays for each method, with the tasks linked here.
#include "writeup/accuracy/begin.h"
#include "writeup/accuracy/converge.h"

#include <fmt/format.h>

namespace writeup::accuracy {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_converge(argc, argv);
  Measuring scene(options, options.bounces);
  const std::vector<Curve> curves = find_curves(scene.study, scene.loaded.scene, options.bounces);
  scene.progress.clear();
  fmt::print("{}", to_text(curves, options));
  if (!options.out.empty()) write_curves(curves, options, options.out);
  return 0;
}

}  // namespace
}  // namespace writeup::accuracy

int main(int argc, char** argv) {
  return writeup::accuracy::run_program(writeup::accuracy::run, argc, argv);
}
