// converge SCENE: error against samples, seconds and rays for each method, with the tasks linked here.
#include "writeup/accuracy/begin.h"
#include "writeup/accuracy/converge.h"

#include <fmt/format.h>

namespace writeup::accuracy {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_converge(argc, argv);
  const pt::LoadedScene loaded = load(options);
  const pt::View view = view_of(loaded, options);
  pt::Progress progress;
  Study study = begin(view, options, options.bounces, progress);
  const std::vector<Curve> curves = find_curves(study, loaded.scene, options.bounces);
  progress.clear();
  fmt::print("{}", to_text(curves, options));
  if (!options.out.empty()) write_curves(curves, options, options.out);
  return 0;
}

}  // namespace
}  // namespace writeup::accuracy

int main(int argc, char** argv) {
  return writeup::accuracy::run_program(writeup::accuracy::run, argc, argv);
}
